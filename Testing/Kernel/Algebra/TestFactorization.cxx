// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Algebra/Factorization.h"

#include "Algebra/PoissonProblem.h"
#include "Algebra/PoissonSolver.h"
#include "Errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace evolving;

namespace
{

/// A unit square of n x n quads, each two triangles; two rows of three are squeezed onto the one
/// before, so that two thirds of the faces are needles.
SurfaceMesh needleSheet(Index n, double thickness)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-0.3, 0.3);
  SurfaceMesh mesh;
  for (Index j = 0; j <= n; ++j)
  {
    for (Index i = 0; i <= n; ++i)
    {
      const double y = j - j % 3 + (j % 3) * thickness;
      mesh.points.emplace_back((i + shift(random)) / n, y / n, 0.0);
    }
  }
  for (Index j = 0; j < n; ++j)
  {
    for (Index i = 0; i < n; ++i)
    {
      const Index a = j * (n + 1) + i;
      mesh.addFace({ a, a + 1, a + n + 2 });
      mesh.addFace({ a, a + n + 2, a + n + 1 });
    }
  }
  return mesh;
}

double largest(const std::vector<double>& values)
{
  double most = 0.0;
  for (const double value : values)
  {
    most = std::max(most, std::abs(value));
  }
  return most;
}

/// b - A x against b, both scaled as conjugateGradients() does.
template <class Value>
double relativeResidual(
  const SparseMatrix& A, const std::vector<Value>& b, const std::vector<Value>& x)
{
  std::vector<Value> product;
  multiply(A, x, product, Execution());
  double residual = 0.0;
  double norm = 0.0;
  for (Index i = 0; i < rowCount(A); ++i)
  {
    const Value r = b[at(i)] - product[at(i)];
    residual += dot(r, r) / diagonalEntry(A, i);
    norm += dot(b[at(i)], b[at(i)]) / diagonalEntry(A, i);
  }
  return std::sqrt(residual / norm);
}

} // namespace

TEST(Factorization, SolvesWhatNeedlesMakeHard)
{
  const PoissonProblem problem(needleSheet(60, 1e-6));
  const SparseMatrix A = problem.pinnedMatrix();
  std::vector<double> x(at(rowCount(A)), 0.0);
  EXPECT_THROW(conjugateGradients(A, problem.rightHandSide(), x, { 1e-9, 500 }, {}), SolverError);
  const int iterations = solveByFactorization(A, problem.rightHandSide(), x, { 1e-9, 500 }, {});
  EXPECT_LE(iterations, 5);
  EXPECT_LE(relativeResidual(A, problem.rightHandSide(), x), 2e-9);
  EXPECT_GT(largest(x), 0.0);
}

TEST(Factorization, SolvesThreeCoordinatesAsOneAfterAnother)
{
  const PoissonProblem problem(needleSheet(20, 1e-5));
  const SparseMatrix A = problem.pinnedMatrix();
  const std::vector<double> b = problem.rightHandSide();
  std::vector<Vec3> points;
  for (const double value : b)
  {
    points.emplace_back(value, -2.0 * value, 0.0);
  }
  std::vector<Vec3> x;
  solveByFactorization(A, points, x, { 1e-9, 500 }, {});
  EXPECT_LE(relativeResidual(A, points, x), 2e-9);
  std::vector<double> alone;
  solveByFactorization(A, b, alone, { 1e-9, 500 }, {});
  const double size = largest(alone);
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    EXPECT_NEAR(x[i].x(), alone[i], 1e-6 * size);
    EXPECT_NEAR(x[i].y(), -2.0 * alone[i], 1e-6 * size);
    EXPECT_EQ(x[i].z(), 0.0);
  }
}

TEST(ConjugateGradients, EndsWhenTheResidualNoLongerFalls)
{
  const PoissonProblem problem(needleSheet(60, 1e-9));
  int iterations = 0;
  const Execution counted(
    nullptr, [&](double) { ++iterations; }, nullptr);
  SolverLimits limits;
  limits.patience = 200;
  std::vector<double> x(problem.mesh.points.size(), 0.0);
  EXPECT_THROW(
    conjugateGradients(problem.pinnedMatrix(), problem.rightHandSide(), x, limits, counted),
    SolverError);
  EXPECT_LT(iterations, limits.maximumIterations / 2);
}

TEST(Factorization, RefusesAMatrixThatIsNotDefinite)
{
  const PoissonProblem problem(needleSheet(10, 1e-2));
  Factorization factors;
  EXPECT_THROW(factors.build(-problem.pinnedMatrix()), SolverError);
}

TEST(Factorization, LeavesToThePlainMethodWhatIsSingular)
{
  // Without a pinned row: constants have no right-hand side, and none is asked for.
  const PoissonProblem problem(needleSheet(10, 0.5));
  const SparseMatrix& A = problem.volumes.stiffness();
  std::vector<double> x;
  solveByFactorization(A, problem.rightHandSide(), x, { 1e-8, 1000 }, {});
  EXPECT_LE(relativeResidual(A, problem.rightHandSide(), x), 2e-8);
}

TEST(PoissonSolver, SolvesWhatDefeatsItsHierarchy)
{
  const PoissonProblem problem(
    needleSheet(80, 1e-6)); // more rows than are factorized to begin with
  ASSERT_GT(problem.mesh.points.size(), 3000U);
  std::vector<double> psi(problem.mesh.points.size(), 0.0);
  const int iterations = PoissonSolver().solve(problem.volumes.stiffness(), problem.isPinned,
    problem.rightHandSide(), psi, { 1e-9, 10000 }, Execution());
  EXPECT_LE(iterations, 100);
  std::vector<double> b = problem.rightHandSide();
  b[0] = 0.0;
  // Rounding makes the residual that the method follows differ from the true one.
  EXPECT_LE(relativeResidual(problem.pinnedMatrix(), b, psi), 1e-6);
}
