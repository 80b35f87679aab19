// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/ClosestPointSweep.h"

#include "Distance/ClosestTriangles.h"
#include "Distance/NearestField.h"
#include "Distance/RowSweep.h"
#include "Distance/TriangleNeighbours.h"

#include <algorithm>
#include <array>

namespace evolving
{

namespace
{

/// Calls visit(j, k) for all rows of a field, in parallel.
template <typename Scalar, typename Visit>
void forEachRow(const NearestField<Scalar>& field, const Execution& execution, const Visit& visit)
{
  const int rows = field.rows();
  constexpr std::int64_t RowGrain = 16;
  execution.forRangeReporting(std::int64_t(rows) * field.slices(), RowGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t row = begin; row < end; ++row)
      {
        visit(static_cast<int>(row % rows), static_cast<int>(row / rows));
      }
    });
}

/// Gives samples the triangles known for them.
template <typename Scalar>
void seed(NearestField<Scalar>& field, const std::vector<Index>& known, const Execution& execution)
{
  forEachRow(field, execution,
    [&](int j, int k)
    {
      for (int i = 0; i < field.width(); ++i)
      {
        const Index triangle = known[static_cast<std::size_t>(field.index(i, j, k))];
        if (triangle != NoIndex)
        {
          field.tryTriangle(field.row(j, k)[i], triangle, field.point(i, j, k));
        }
      }
    });
}

/// One row of a sweep: triangles of three rows before it, then of the samples beside, both ways.
template <typename Scalar>
void propagateAlong(NearestField<Scalar>& field, int j, int k, const SweepDirection& direction)
{
  const int beforeJ = direction.yUp ? j - 1 : j + 1;
  const int beforeK = direction.zUp ? k - 1 : k + 1;
  const std::array<NeighbourRow, 3> before{ field.neighbourRow(j, k, beforeJ, k),
    field.neighbourRow(j, k, j, beforeK), field.neighbourRow(j, k, beforeJ, beforeK) };
  Nearest* row = field.row(j, k);
  const float step = field.stepAlongRow();
  for (int i = 0; i < field.width(); ++i)
  {
    if (field.isSettled(row[i]))
    {
      continue;
    }
    TriedTriangles tried;
    const auto point = field.point(i, j, k);
    for (const NeighbourRow& other : before)
    {
      if (other.samples)
      {
        field.tryNeighbour(row[i], other.samples[i], point, other.step, tried);
      }
    }
    if (i > 0)
    {
      field.tryNeighbour(row[i], row[i - 1], point, step, tried);
    }
  }
  for (int i = field.width() - 2; i >= 0; --i)
  {
    if (!field.isSettled(row[i]))
    {
      TriedTriangles tried;
      field.tryNeighbour(row[i], row[i + 1], field.point(i, j, k), step, tried);
    }
  }
}

/// Carries triangles away from the surface, once in each of the four directions of y and z.
template <typename Scalar>
void propagate(NearestField<Scalar>& field, const Execution& execution)
{
  constexpr std::array<SweepDirection, 4> Order{ { { true, true }, { false, true },
    { false, false }, { true, false } } };
  for (std::size_t n = 0; n < Order.size(); ++n)
  {
    const auto from = static_cast<double>(n) / static_cast<double>(Order.size());
    const auto to = static_cast<double>(n + 1) / static_cast<double>(Order.size());
    visitRowsInOrder(field.rows(), field.slices(), Order[n], execution.phase(from, to),
      [&](int j, int k) { propagateAlong(field, j, k, Order[n]); });
  }
}

/// Every sample marked walks over the mesh to a closer triangle, while there is one.
template <typename Scalar>
void descend(NearestField<Scalar>& field, const TriangleNeighbours& neighbours,
  const std::vector<char>& marked, const Execution& execution)
{
  const auto walk = [&](Nearest& sample, const auto& point)
  {
    for (Index from = NoIndex; sample.triangle != from;)
    {
      from = sample.triangle;
      for (const Index* next = neighbours.begin(from); next != neighbours.end(from); ++next)
      {
        field.tryTriangle(sample, *next, point);
      }
    }
  };
  forEachRow(field, execution,
    [&](int j, int k)
    {
      for (int i = 0; i < field.width(); ++i)
      {
        Nearest& sample = field.row(j, k)[i];
        if (marked[static_cast<std::size_t>(field.index(i, j, k))] && !field.isSettled(sample))
        {
          walk(sample, field.point(i, j, k));
        }
      }
    });
}

/// The nine rows around a row, itself included.
template <typename Scalar>
std::array<NeighbourRow, 9> rowsAround(const NearestField<Scalar>& field, int j, int k)
{
  std::array<NeighbourRow, 9> rows;
  for (int n = 0; n < 9; ++n)
  {
    rows[static_cast<std::size_t>(n)] = field.neighbourRow(j, k, j + n % 3 - 1, k + n / 3 - 1);
  }
  return rows;
}

/// The sample after it has tried the triangles of those of the 26 around it that are marked.
template <typename Scalar>
Nearest refinedSample(const NearestField<Scalar>& field, int i, int j, int k,
  const std::array<NeighbourRow, 9>& rows, const std::vector<char>& marked)
{
  Nearest sample = field.row(j, k)[i];
  if (field.isSettled(sample))
  {
    return sample;
  }
  const auto point = field.point(i, j, k);
  const int first = std::max(i - 1, 0);
  const int last = std::min(i + 1, field.width() - 1);
  TriedTriangles tried;
  for (const NeighbourRow& row : rows)
  {
    for (int other = first; row.samples && other <= last; ++other)
    {
      if (marked[static_cast<std::size_t>(row.samples - field.row(0, 0) + other)])
      {
        const float step = other == i ? row.step : row.step + field.stepAlongRow();
        field.tryNeighbour(sample, row.samples[other], point, step, tried);
      }
    }
  }
  return sample;
}

/// What every sample has after trying its neighbours', as they are now, so that order is no
/// matter.
template <typename Scalar>
std::vector<Index> refined(
  const NearestField<Scalar>& field, const std::vector<char>& marked, const Execution& execution)
{
  std::vector<Index> result(marked.size());
  forEachRow(field, execution,
    [&](int j, int k)
    {
      const std::array<NeighbourRow, 9> rows = rowsAround(field, j, k);
      for (int i = 0; i < field.width(); ++i)
      {
        result[static_cast<std::size_t>(field.index(i, j, k))] =
          refinedSample(field, i, j, k, rows, marked).triangle;
      }
    });
  return result;
}

/// Gives the samples their new triangles, and marks those for which one is new.
template <typename Scalar>
std::vector<char> adopt(
  NearestField<Scalar>& field, const std::vector<Index>& triangles, const Execution& execution)
{
  std::vector<char> changed(triangles.size(), 0);
  forEachRow(field, execution,
    [&](int j, int k)
    {
      for (int i = 0; i < field.width(); ++i)
      {
        const auto s = static_cast<std::size_t>(field.index(i, j, k));
        Nearest& sample = field.row(j, k)[i];
        changed[s] = sample.triangle != triangles[s];
        if (changed[s])
        {
          field.tryTriangle(sample, triangles[s], field.point(i, j, k));
        }
      }
    });
  return changed;
}

/// Descends and refines, then again around the samples for which that changed something.
template <typename Scalar>
std::vector<Index> improve(
  NearestField<Scalar>& field, const TriangleNeighbours& neighbours, const Execution& execution)
{
  const auto count =
    static_cast<std::size_t>(GridIndex(field.width()) * field.rows() * field.slices());
  std::vector<char> changed(count, 1);
  std::vector<Index> triangles;
  constexpr std::array<double, 4> Ends{ 0.0, 0.8, 0.9, 1.0 }; // the first round is the long one
  for (std::size_t round = 0; round + 1 < Ends.size(); ++round)
  {
    const Execution phase = execution.phase(Ends[round], Ends[round + 1]);
    descend(field, neighbours, changed, phase.phase(0.0, 0.45));
    triangles = refined(field, changed, phase.phase(0.45, 0.95));
    changed = adopt(field, triangles, phase.phase(0.95, 1.0));
  }
  return triangles;
}

template <typename Scalar>
std::vector<Index> sweepAs(const SurfaceMesh& mesh, const AABBTree& tree, const DistanceGrid& grid,
  const Execution& execution)
{
  NearestField<Scalar> field(tree, grid);
  field.drawBand(execution.phase(0.0, 0.2));
  if (!containsAll(grid, tree))
  {
    const Execution seeding = execution.phase(0.2, 0.35);
    const std::vector<Index> boundary = queryBoundaryTriangles(tree, grid, seeding.phase(0.0, 0.9));
    seed(field, boundary, seeding.phase(0.9, 1.0));
  }
  propagate(field, execution.phase(0.35, 0.55));
  const TriangleNeighbours neighbours(mesh, tree, execution.phase(0.55, 0.6));
  return improve(field, neighbours, execution.phase(0.6, 1.0));
}

/// The largest coordinate, in cells, of the mesh and the grid seen from the grid's middle.
double largestCoordinate(const AABBTree& tree, const DistanceGrid& grid)
{
  const Extent& e = grid.extent;
  Box box(grid.point(e[0], e[2], e[4]));
  box.extend(grid.point(e[1], e[3], e[5]));
  const Vec3 middle = box.center();
  box.extend(tree.nodes().front().box);
  const Vec3 reach = (box.max() - middle).cwiseMax(middle - box.min());
  return reach.maxCoeff() / grid.spacing.maxCoeff();
}

} // namespace

std::vector<Index> sweepClosestTriangles(const SurfaceMesh& mesh, const AABBTree& tree,
  const DistanceGrid& grid, const Execution& execution)
{
  constexpr double GoodForFloats = 4096.0; // they round to less than a thousandth of a cell
  return largestCoordinate(tree, grid) < GoodForFloats
    ? sweepAs<float>(mesh, tree, grid, execution)
    : sweepAs<double>(mesh, tree, grid, execution);
}

} // namespace evolving
