// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Algebra/Aggregation.h"

#include "Algebra/PoissonProblem.h"
#include "Shapes/Spheres.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <vector>

using namespace evolving;

namespace
{

using Rows = std::vector<Index>;

SparseMatrix sparse(const Eigen::MatrixXd& dense)
{
  SparseMatrix A = dense.sparseView();
  A.makeCompressed();
  return A;
}

/// By the definition, entry by entry.
bool isStrong(const Eigen::MatrixXd& A, Index i, Index j, double threshold)
{
  return i != j && A(i, j) != 0.0 && std::abs(A(i, j)) >= threshold * std::sqrt(A(i, i) * A(j, j));
}

/// Symmetric, about `entries` of them a row, diagonals of all sizes.
Eigen::MatrixXd randomMatrix(Index n, double entries, std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  for (Index i = 0; i < n; ++i)
  {
    A(i, i) = std::exp(4.0 * uniform(random) - 2.0);
    for (Index j = 0; j < i; ++j)
    {
      const double value = uniform(random) - 0.7;
      A(i, j) = A(j, i) = uniform(random) * static_cast<double>(n) < entries ? value : 0.0;
    }
  }
  return A;
}

/// The three passes on a dense matrix, each by its sentence.
Rows aggregatesOf(const Eigen::MatrixXd& A, double threshold)
{
  const auto n = static_cast<Index>(A.rows());
  Rows of(static_cast<std::size_t>(n), NoIndex);
  Index count = 0;
  std::vector<Rows> strong(of.size());
  for (Index i = 0; i < n; ++i)
  {
    for (Index j = 0; j < n; ++j)
    {
      if (isStrong(A, i, j, threshold))
      {
        strong[at(i)].push_back(j);
      }
    }
  }
  const auto isFree = [&](Index i) { return of[at(i)] == NoIndex; };
  for (Index i = 0; i < n; ++i) // whole neighbourhoods
  {
    const Rows& around = strong[at(i)];
    if (isFree(i) && !around.empty() && std::all_of(around.begin(), around.end(), isFree))
    {
      of[at(i)] = count;
      std::for_each(around.begin(), around.end(), [&](Index j) { of[at(j)] = count; });
      ++count;
    }
  }
  const Rows whole = of;
  for (Index i = 0; i < n; ++i) // what is left goes to its strongest neighbour's
  {
    double strongest = 0.0;
    for (const Index j : strong[at(i)])
    {
      if (whole[at(i)] == NoIndex && whole[at(j)] != NoIndex && std::abs(A(i, j)) > strongest)
      {
        strongest = std::abs(A(i, j));
        of[at(i)] = whole[at(j)];
      }
    }
  }
  for (Index i = 0; i < n; ++i) // and what has none there, together
  {
    if (isFree(i) && !strong[at(i)].empty())
    {
      of[at(i)] = count++;
      for (const Index j : strong[at(i)])
      {
        of[at(j)] = isFree(j) ? of[at(i)] : of[at(j)];
      }
    }
  }
  return of;
}

/// -1 to each of two neighbours.
Eigen::MatrixXd chain(Index n)
{
  Eigen::MatrixXd A = 2.0 * Eigen::MatrixXd::Identity(n, n);
  for (Index i = 0; i + 1 < n; ++i)
  {
    A(i, i + 1) = A(i + 1, i) = -1.0;
  }
  return A;
}

} // namespace

TEST(Aggregation, PutsEveryConnectedRowIntoOneAggregate)
{
  const PoissonProblem problem(shapes::bumpySphere(4));
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

TEST(Aggregation, OfAChainAreThreeByThree)
{
  // Whole neighbourhoods are those of 0, 3 and 6; the last row joins its only neighbour.
  const Aggregation result = aggregate(sparse(chain(9)), 0.08);
  EXPECT_EQ(result.aggregateOfRow, (Rows{ 0, 0, 1, 1, 1, 2, 2, 2, 2 }));
  EXPECT_EQ(result.count, 3);
}

TEST(Aggregation, AConnectionIsStrongFromTheThresholdOn)
{
  // sqrt(4 * 9) = 6, half of which is 3.
  Eigen::MatrixXd A(2, 2);
  A << 4.0, -3.0, -3.0, 9.0;
  EXPECT_EQ(aggregate(sparse(A), 0.5).aggregateOfRow, (Rows{ 0, 0 }));
  A(0, 1) = A(1, 0) = 3.0; // the sign means nothing
  EXPECT_EQ(aggregate(sparse(A), 0.5).aggregateOfRow, (Rows{ 0, 0 }));
  A(0, 1) = A(1, 0) = std::nextafter(3.0, 0.0);
  EXPECT_EQ(aggregate(sparse(A), 0.5).aggregateOfRow, (Rows{ NoIndex, NoIndex }));
  EXPECT_EQ(aggregate(sparse(A), 0.5).count, 0);
}

TEST(Aggregation, StayOnLinesOfStrongConnections)
{
  // A grid of 8 x 8 whose columns hardly know of each other.
  constexpr Index Side = 8;
  const Eigen::MatrixXd line = chain(Side);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(Side * Side, Side * Side);
  for (Index i = 0; i < Side * Side; ++i)
  {
    for (Index j = 0; j < Side * Side; ++j)
    {
      A(i, j) = (i / Side == j / Side ? line(i % Side, j % Side) : 0.0) +
        (i % Side == j % Side ? 0.01 * line(i / Side, j / Side) : 0.0);
    }
  }
  const Aggregation result = aggregate(sparse(A), 0.08);
  std::vector<Index> columnOf(static_cast<std::size_t>(result.count), NoIndex);
  for (Index i = 0; i < Side * Side; ++i)
  {
    Index& column = columnOf[at(result.aggregateOfRow[at(i)])];
    EXPECT_TRUE(column == NoIndex || column == i / Side) << i;
    column = i / Side;
  }
}

TEST(Aggregation, AgreesWithItsDefinitionOnRandomMatrices)
{
  std::mt19937 random(5);
  int withoutWholeNeighbourhood = 0;
  for (int trial = 0; trial < 300; ++trial)
  {
    const Index n = 1 + trial % 40;
    const Eigen::MatrixXd A = randomMatrix(n, 1.0 + trial % 5, random);
    for (const double threshold : { 0.0, 0.08, 0.4 })
    {
      const Aggregation result = aggregate(sparse(A), threshold);
      const Rows expected = aggregatesOf(A, threshold);
      ASSERT_EQ(result.aggregateOfRow, expected) << trial << ' ' << threshold;
      const std::set<Index> used(expected.begin(), expected.end());
      ASSERT_EQ(result.count, static_cast<Index>(used.size() - used.count(NoIndex)));
      withoutWholeNeighbourhood += used.count(NoIndex) != 0 ? 1 : 0;
    }
  }
  EXPECT_GT(withoutWholeNeighbourhood, 100); // rows without strong connections were among them
}

TEST(Aggregation, IsThatOfEachPartOfAMatrixOfTwo)
{
  std::mt19937 random(6);
  const Eigen::MatrixXd first = randomMatrix(23, 3.0, random);
  const Eigen::MatrixXd second = randomMatrix(31, 4.0, random);
  Eigen::MatrixXd both = Eigen::MatrixXd::Zero(54, 54);
  both.topLeftCorner(23, 23) = first;
  both.bottomRightCorner(31, 31) = second;
  const Aggregation whole = aggregate(sparse(both), 0.08);
  const Aggregation one = aggregate(sparse(first), 0.08);
  const Aggregation other = aggregate(sparse(second), 0.08);
  EXPECT_EQ(whole.count, one.count + other.count);
  const auto partition = [&](Index a, Index b)
  { return whole.aggregateOfRow[at(a)] == whole.aggregateOfRow[at(b)]; };
  for (Index a = 0; a < 54; ++a)
  {
    for (Index b = 0; b < 54; ++b)
    {
      const bool expected = (a < 23) == (b < 23) &&
        (a < 23 ? one.aggregateOfRow[at(a)] == one.aggregateOfRow[at(b)]
                : other.aggregateOfRow[at(a - 23)] == other.aggregateOfRow[at(b - 23)]);
      const bool areAlone = whole.aggregateOfRow[at(a)] == NoIndex;
      ASSERT_TRUE(areAlone || partition(a, b) == expected) << a << ' ' << b;
    }
  }
}

TEST(Aggregation, DoesNotDependOnTheUnit)
{
  const PoissonProblem problem(shapes::bumpySphere(3));
  const SparseMatrix A = problem.pinnedMatrix();
  const Rows expected = aggregate(A, 0.08).aggregateOfRow;
  for (const double scale : { 0x1p-40, 0x1p-1, 0x1p40 })
  {
    EXPECT_EQ(aggregate(SparseMatrix(scale * A), 0.08).aggregateOfRow, expected) << scale;
  }
}
