// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/ClosestTriangles.h"

namespace evolving
{

namespace
{

/// The rows of a grid along x, numbered in memory order.
struct Rows
{
  explicit Rows(const DistanceGrid& grid)
    : count(std::int64_t(grid.dimension(1)) * grid.dimension(2))
    , width(grid.dimension(0))
    , height(grid.dimension(1))
    , slices(grid.dimension(2))
  {
  }

  /// Does the row consist of samples of the grid's faces?
  bool isOnBoundary(std::int64_t row) const
  {
    const std::int64_t j = row % this->height;
    const std::int64_t k = row / this->height;
    return j == 0 || k == 0 || j == this->height - 1 || k == this->slices - 1;
  }

  std::int64_t count;
  int width;
  int height;
  int slices;
};

Vec3 samplePoint(const DistanceGrid& grid, const Rows& rows, std::int64_t row, int i)
{
  return grid.point(grid.extent[0] + i, grid.extent[2] + static_cast<int>(row % rows.height),
    grid.extent[4] + static_cast<int>(row / rows.height));
}

} // namespace

void forEachSample(const DistanceGrid& grid, const Execution& execution, const SampleVisit& visit)
{
  const Rows rows(grid);
  constexpr std::int64_t RowGrain = 16;
  execution.forRangeReporting(rows.count, RowGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t row = begin; row < end; ++row)
      {
        for (int i = 0; i < rows.width; ++i)
        {
          visit(row * rows.width + i, samplePoint(grid, rows, row, i));
        }
      }
    });
}

std::vector<Index> queryClosestTriangles(
  const AABBTree& tree, const DistanceGrid& grid, const Execution& execution)
{
  const Rows rows(grid);
  std::vector<Index> triangles(static_cast<std::size_t>(grid.sampleCount()), NoIndex);
  forEachSample(grid, execution,
    [&](GridIndex sample, const Vec3& point)
    {
      const bool startsRow = sample % rows.width == 0;
      const auto s = static_cast<std::size_t>(sample);
      const Index guess = startsRow ? NoIndex : triangles[s - 1];
      triangles[s] = tree.closest(point, std::numeric_limits<double>::infinity(), guess).triangle;
    });
  return triangles;
}

std::vector<Index> queryBoundaryTriangles(
  const AABBTree& tree, const DistanceGrid& grid, const Execution& execution)
{
  const Rows rows(grid);
  std::vector<Index> triangles(static_cast<std::size_t>(grid.sampleCount()), NoIndex);
  constexpr std::int64_t RowGrain = 4;
  execution.forRangeReporting(rows.count, RowGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t row = begin; row < end; ++row)
      {
        Index guess = NoIndex;
        const int step = rows.isOnBoundary(row) ? 1 : std::max(1, rows.width - 1);
        for (int i = 0; i < rows.width; i += step)
        {
          const Vec3 point = samplePoint(grid, rows, row, i);
          guess = tree.closest(point, std::numeric_limits<double>::infinity(), guess).triangle;
          triangles[static_cast<std::size_t>(row * rows.width + i)] = guess;
        }
      }
    });
  return triangles;
}

std::vector<float> closestPoints(const SurfaceMesh& mesh, const DistanceGrid& grid,
  const std::vector<Index>& triangles, const Vec3& offset, const Execution& execution)
{
  std::vector<float> points(3 * triangles.size());
  forEachSample(grid, execution,
    [&](GridIndex sample, const Vec3& point)
    {
      const Triangle triangle = triangleOf(mesh, triangles[static_cast<std::size_t>(sample)]);
      const Vec3 closest = closestPointOnTriangle(point, triangle).point + offset;
      Eigen::Map<Eigen::Vector3f>(points.data() + 3 * sample) = closest.cast<float>();
    });
  return points;
}

bool containsAll(const DistanceGrid& grid, const Box& surface)
{
  const Extent& e = grid.extent;
  const Box samples(grid.point(e[0], e[2], e[4]), grid.point(e[1], e[3], e[5]));
  return samples.contains(surface);
}

} // namespace evolving
