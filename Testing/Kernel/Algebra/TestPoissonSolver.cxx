// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Algebra/PoissonSolver.h"

#include "Algebra/PoissonProblem.h"
#include "Errors.h"
#include "Mesh/MeshTopology.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "ThreadedExecution.h"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;

TEST(PoissonSolver, AgreesWithAFactorization)
{
  const PoissonProblem problem(shapes::bumpySphere(5));
  std::vector<double> psi(problem.mesh.points.size(), 0.0);
  PoissonSolver solver;
  solver.solve(problem.volumes.stiffness(), problem.isPinned, problem.rightHandSide(), psi,
    { 1e-11, 1000 }, Execution());
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(problem.pinnedMatrix());
  std::vector<double> b = problem.rightHandSide();
  b[0] = 0.0;
  const Eigen::VectorXd expected =
    factors.solve(Eigen::Map<const Eigen::VectorXd>(b.data(), static_cast<Eigen::Index>(b.size())));
  EXPECT_EQ(psi[0], 0.0);
  for (std::size_t i = 0; i < psi.size(); ++i)
  {
    EXPECT_NEAR(psi[i], expected[static_cast<Eigen::Index>(i)], 1e-8);
  }
}

TEST(PoissonSolver, StaysCheapWhileTheSurfaceMoves)
{
  PoissonProblem problem(shapes::bumpySphere(4));
  std::vector<double> psi(problem.mesh.points.size(), 0.0);
  PoissonSolver solver;
  for (int step = 0; step < 40; ++step)
  {
    for (Vec3& p : problem.mesh.points)
    {
      p.x() *= 1.02; // 2.2 times as long at the end
    }
    problem.volumes.update(problem.mesh, Execution());
    const int iterations = solver.solve(problem.volumes.stiffness(), problem.isPinned,
      problem.rightHandSide(), psi, { 1e-8, 1000 }, Execution());
    EXPECT_LE(iterations, 15) << "step " << step;
  }
}

TEST(PoissonSolver, SurvivesAMatrixThatIsZeroInPlaces)
{
  // A component that has shrunk to a point says nothing about its potential.
  const SurfaceMesh mesh =
    shapes::merged(icosphere(1), shapes::transformed(icosphere(1), 0.0, Vec3(3, 0, 0)));
  PoissonProblem problem(mesh);
  problem.isPinned[42] = 1;
  std::vector<double> b = problem.rightHandSide();
  for (std::size_t v = 42; v < b.size(); ++v)
  {
    b[v] = 0.0;
  }
  std::vector<double> psi(b.size(), 0.0);
  PoissonSolver solver;
  solver.solve(problem.volumes.stiffness(), problem.isPinned, b, psi, { 1e-8, 100 }, Execution());
  for (const double value : psi)
  {
    EXPECT_TRUE(std::isfinite(value));
  }
}

TEST(PoissonSolver, HasTheSameBitsForAnyNumberOfThreads)
{
  const PoissonProblem problem(shapes::bumpySphere(5));
  std::vector<double> serial(problem.mesh.points.size(), 0.0);
  PoissonSolver().solve(problem.volumes.stiffness(), problem.isPinned, problem.rightHandSide(),
    serial, { 1e-8, 1000 }, Execution());
  for (const int threads : { 1, 2, 8 })
  {
    std::vector<double> psi(serial.size(), 0.0);
    PoissonSolver().solve(problem.volumes.stiffness(), problem.isPinned, problem.rightHandSide(),
      psi, { 1e-8, 1000 }, threadedExecution(threads, 3));
    EXPECT_EQ(psi, serial) << threads << " threads";
  }
}
