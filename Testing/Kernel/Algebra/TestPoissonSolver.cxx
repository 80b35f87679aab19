// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Algebra/PoissonSolver.h"

#include "Algebra/Aggregation.h"
#include "Errors.h"
#include "Evolution/EvolutionShapes.h"
#include "Operators/FiniteVolumes.h"
#include "ThreadedExecution.h"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <set>

using namespace evolving;

namespace
{

/// A Poisson problem on a closed surface.
struct Problem
{
  SurfaceMesh mesh;
  MeshTopology topology;
  FiniteVolumes volumes;
  std::vector<char> isPinned;

  explicit Problem(const SurfaceMesh& surface)
    : mesh(surface)
    , topology(mesh)
    , volumes(topology)
    , isPinned(mesh.points.size(), 0)
  {
    this->volumes.update(this->mesh, Execution());
    this->isPinned[0] = 1;
  }

  std::vector<double> rightHandSide() const
  {
    std::vector<double> b;
    double sum = 0.0;
    for (std::size_t i = 0; i < this->mesh.points.size(); ++i)
    {
      const Vec3& p = this->mesh.points[i];
      b.push_back(this->volumes.coVolumes()[i] * std::sin(2.0 * p.x() + p.y() * p.z()));
      sum += b.back();
    }
    for (double& value : b)
    {
      value -= sum / static_cast<double>(b.size());
    }
    return b;
  }

  SparseMatrix pinnedMatrix() const
  {
    SparseMatrix A = this->volumes.stiffness();
    std::vector<double> b(this->mesh.points.size(), 0.0);
    eliminateKnown(this->isPinned, b, A, b, Execution());
    return A;
  }
};

std::vector<double> unitVector(std::size_t size, std::size_t i)
{
  std::vector<double> unit(size, 0.0);
  unit[i] = 1.0;
  return unit;
}

} // namespace

TEST(Aggregation, PutsEveryConnectedRowIntoOneAggregate)
{
  const Problem problem(shapes::bumpySphere(4));
  const SparseMatrix A = problem.pinnedMatrix();
  const Aggregation result = aggregate(A, 0.08);
  std::set<Index> used;
  for (std::size_t i = 0; i < result.aggregateOfRow.size(); ++i)
  {
    const Index aggregate = result.aggregateOfRow[i];
    EXPECT_EQ(aggregate == NoIndex, problem.isPinned[i] != 0);
    if (aggregate != NoIndex)
    {
      used.insert(aggregate);
    }
  }
  EXPECT_EQ(static_cast<Index>(used.size()), result.count);
  EXPECT_EQ(*used.rbegin(), result.count - 1);
  // Neighbourhoods of six: about a seventh of the rows.
  EXPECT_LT(4 * result.count, A.rows());
}

TEST(Multigrid, IsSymmetricAndPositiveDefinite)
{
  const Problem problem(shapes::bumpySphere(5)); // two levels
  Multigrid multigrid;
  multigrid.build(problem.pinnedMatrix(), Execution());
  EXPECT_GE(multigrid.levelCount(), 2);
  const std::size_t n = problem.mesh.points.size();
  std::vector<double> fromFirst;
  std::vector<double> fromSecond;
  for (const std::size_t i : { std::size_t(5), std::size_t(1234), std::size_t(9000) })
  {
    for (const std::size_t j : { std::size_t(6), std::size_t(77), std::size_t(10241) })
    {
      multigrid.apply(unitVector(n, i), fromFirst, Execution());
      multigrid.apply(unitVector(n, j), fromSecond, Execution());
      EXPECT_NEAR(fromFirst[j], fromSecond[i], 1e-12 * fromFirst[i]);
      EXPECT_GT(fromFirst[i], 0.0);
    }
  }
}

TEST(Multigrid, IterationsDoNotGrowWithTheMesh)
{
  std::vector<int> iterations;
  for (const int level : { 4, 5, 6 })
  {
    const Problem problem(shapes::bumpySphere(level));
    const SparseMatrix A = problem.pinnedMatrix();
    std::vector<double> b = problem.rightHandSide();
    b[0] = 0.0;
    std::vector<double> psi(b.size(), 0.0);
    Multigrid multigrid;
    multigrid.build(A, Execution());
    const SolverLimits limits{ 1e-8, 1000 };
    iterations.push_back(conjugateGradients(A, b, psi, limits, Execution(), &multigrid));
    std::vector<double> plain(b.size(), 0.0);
    EXPECT_LT(4 * iterations.back(), conjugateGradients(A, b, plain, limits, Execution()));
  }
  EXPECT_LE(iterations[0], 2); // factorized
  EXPECT_LE(iterations[2], iterations[1] + 6);
  EXPECT_LE(iterations[2], 30);
}

TEST(PoissonSolver, AgreesWithAFactorization)
{
  const Problem problem(shapes::bumpySphere(5));
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
  Problem problem(shapes::bumpySphere(4));
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
    shapes::together(icosphere(1), shapes::transformed(icosphere(1), 0.0, Vec3(3, 0, 0)));
  Problem problem(mesh);
  problem.isPinned[42] = 1;
  std::vector<double> b = problem.rightHandSide();
  std::fill(b.begin() + 42, b.end(), 0.0);
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
  const Problem problem(shapes::bumpySphere(5));
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
