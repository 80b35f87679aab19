// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Algebra/ConjugateGradients.h"

#include "Errors.h"
#include "Shapes/Draws.h"
#include "ThreadedExecution.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <random>

using namespace evolving;

namespace
{

/// A positive definite band matrix with random entries.
SparseMatrix randomMatrix(Index n, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  std::vector<Eigen::Triplet<double, Index>> entries;
  for (Index i = 0; i < n; ++i)
  {
    double sum = 0.0;
    for (Index step : { 1, 7, 31 })
    {
      const Index j = (i + step) % n;
      const double entry = value(random);
      entries.emplace_back(i, j, entry);
      entries.emplace_back(j, i, entry);
      entries.emplace_back(j, j, std::abs(entry));
      sum += std::abs(entry);
    }
    entries.emplace_back(i, i, sum + 0.01 * (1.0 + 1000.0 * (i % 5))); // badly scaled
  }
  SparseMatrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

std::vector<Vec3> randomPoints(Index n, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  std::vector<Vec3> points;
  for (Index i = 0; i < n; ++i)
  {
    points.push_back(shapes::drawnVector(value, random));
  }
  return points;
}

} // namespace

TEST(ConjugateGradients, AgreesWithADenseFactorization)
{
  const Index n = 200;
  const SparseMatrix A = randomMatrix(n, 1);
  const std::vector<Vec3> b = randomPoints(n, 2);
  std::vector<Vec3> x(b.size(), Vec3::Ones());
  conjugateGradients(A, b, x, { 1e-13, 1000 }, {});
  const Eigen::Map<const Eigen::Matrix<double, 3, Eigen::Dynamic>> right(b.front().data(), 3, n);
  const Eigen::MatrixXd expected = Eigen::MatrixXd(A).ldlt().solve(right.transpose());
  for (Index i = 0; i < n; ++i)
  {
    EXPECT_NEAR((x[static_cast<std::size_t>(i)] - expected.row(i).transpose()).norm(), 0.0, 1e-10);
  }
}

TEST(ConjugateGradients, StopsAtTheToleranceAndNotFarBelow)
{
  const SparseMatrix A = randomMatrix(3000, 3);
  const std::vector<Vec3> b = randomPoints(3000, 4);
  std::vector<Vec3> rough(b.size(), Vec3::Zero());
  std::vector<Vec3> fine(b.size(), Vec3::Zero());
  const int few = conjugateGradients(A, b, rough, { 1e-3, 1000 }, {});
  const int many = conjugateGradients(A, b, fine, { 1e-12, 1000 }, {});
  EXPECT_LT(2 * few, many);
  EXPECT_GT(few, 0);
  // A solution as the guess needs nothing.
  EXPECT_EQ(conjugateGradients(A, b, fine, { 1e-11, 1000 }, {}), 0);
}

TEST(ConjugateGradients, HasTheSameBitsForAnyNumberOfThreads)
{
  const Index n = 20000; // several chunks
  const SparseMatrix A = randomMatrix(n, 5);
  const std::vector<Vec3> b = randomPoints(n, 6);
  std::vector<Vec3> serial(b.size(), Vec3::Zero());
  conjugateGradients(A, b, serial, { 1e-10, 1000 }, {});
  for (const int threads : { 1, 2, 8 })
  {
    std::vector<Vec3> x(b.size(), Vec3::Zero());
    conjugateGradients(A, b, x, { 1e-10, 1000 }, threadedExecution(threads, 7));
    EXPECT_TRUE(x == serial) << threads << " threads";
  }
}

TEST(ConjugateGradients, SaysWhenItCannotSolve)
{
  const SparseMatrix A = randomMatrix(500, 8);
  const std::vector<Vec3> b = randomPoints(500, 9);
  std::vector<Vec3> x(b.size(), Vec3::Zero());
  EXPECT_THROW(conjugateGradients(A, b, x, { 1e-12, 3 }, {}), SolverError);
  const SparseMatrix indefinite = -A;
  EXPECT_THROW(conjugateGradients(indefinite, b, x, { 1e-12, 1000 }, {}), SolverError);
  std::vector<Vec3> infinite = b;
  infinite[7].x() = std::nan("");
  EXPECT_THROW(conjugateGradients(A, infinite, x, { 1e-12, 1000 }, {}), SolverError);
}

TEST(ConjugateGradients, ZeroRightHandSideGivesZero)
{
  const SparseMatrix A = randomMatrix(50, 10);
  std::vector<double> x(50, 3.0);
  EXPECT_EQ(conjugateGradients(A, std::vector<double>(50, 0.0), x, {}, {}), 0);
  EXPECT_EQ(x, std::vector<double>(50, 0.0));
}

TEST(ConjugateGradients, ForgetsAGuessThatIsWorseThanNone)
{
  const SparseMatrix A = randomMatrix(500, 14);
  const std::vector<Vec3> b = randomPoints(500, 15);
  std::vector<Vec3> expected(b.size(), Vec3::Zero());
  conjugateGradients(A, b, expected, {}, {});
  for (const double bad : { std::nan(""), 1e30 })
  {
    std::vector<Vec3> x(b.size(), Vec3::Constant(bad));
    conjugateGradients(A, b, x, {}, {});
    EXPECT_TRUE(x == expected);
  }
}

TEST(ConjugateGradients, AsksWhetherToStop)
{
  const SparseMatrix A = randomMatrix(500, 11);
  const std::vector<Vec3> b = randomPoints(500, 12);
  std::vector<Vec3> x(b.size(), Vec3::Zero());
  const Execution stopped(nullptr, nullptr, [] { return true; });
  EXPECT_THROW(conjugateGradients(A, b, x, {}, stopped), Cancelled);
}

TEST(SparseMatrix, EliminatesKnownRowsSymmetrically)
{
  const Index n = 60;
  const SparseMatrix A = randomMatrix(n, 13);
  std::vector<double> solution(static_cast<std::size_t>(n));
  std::vector<char> isKnown(solution.size(), 0);
  for (std::size_t i = 0; i < solution.size(); ++i)
  {
    solution[i] = std::sin(static_cast<double>(i));
    isKnown[i] = i % 4 == 1;
  }
  std::vector<double> b;
  multiply(A, solution, b, Execution());
  SparseMatrix reduced = A;
  eliminateKnown(isKnown, solution, reduced, b, Execution());
  const Eigen::MatrixXd dense(reduced);
  EXPECT_EQ((dense - dense.transpose()).norm(), 0.0);
  EXPECT_EQ(reduced.nonZeros(), A.nonZeros());
  std::vector<double> x(solution.size(), 0.0);
  conjugateGradients(reduced, b, x, { 1e-13, 1000 }, {});
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    EXPECT_NEAR(x[i], solution[i], 1e-9);
  }
}
