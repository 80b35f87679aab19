// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/UnsignedDistance.h"

#include "Distance/ClosestTriangles.h"
#include "Distance/Sweeping/DistanceOctree.h"
#include "Distance/Sweeping/FastSweeping.h"

#include <cmath>
#include <utility>

namespace evolving
{

namespace
{

/// The way to triangles outside the grid leads past the grid's faces.
void freezeBoundary(
  SweptField& field, const AABBTree& tree, const DistanceGrid& grid, const Execution& execution)
{
  const double h = grid.spacing.maxCoeff();
  const std::vector<Index> boundary = queryBoundaryTriangles(tree, grid, execution.phase(0.0, 0.9));
  forEachSample(grid, execution.phase(0.9, 1.0),
    [&](GridIndex s, const Vec3& point)
    {
      if (boundary[at(s)] != NoIndex)
      {
        const Triangle& triangle = tree.triangle(boundary[at(s)]);
        const double squared = closestPointOnTriangle(point, triangle).squaredDistance;
        field.freeze(s, static_cast<float>(std::sqrt(squared) / h));
      }
    });
}

} // namespace

UnsignedDistance distanceToTriangles(const SurfaceMesh& mesh, const DistanceGrid& grid,
  std::vector<Index> triangles, const Execution& execution)
{
  UnsignedDistance result;
  result.distance.resize(triangles.size());
  forEachSample(grid, execution,
    [&](GridIndex s, const Vec3& point)
    {
      const Triangle triangle = triangleOf(mesh, triangles[at(s)]);
      const double squared = closestPointOnTriangle(point, triangle).squaredDistance;
      result.distance[at(s)] = static_cast<float>(std::sqrt(squared));
    });
  result.triangle = std::move(triangles);
  return result;
}

UnsignedDistance distanceBySweeping(
  const AABBTree& tree, const DistanceGrid& grid, int numberOfSweeps, const Execution& execution)
{
  const double h = grid.spacing.maxCoeff();
  const DistanceOctree octree(tree, grid, execution.phase(0.0, 0.4));
  SweptField field({ grid.dimension(0), grid.dimension(1), grid.dimension(2) });
  UnsignedDistance result;
  result.triangle.assign(field.distance.size(), NoIndex);
  // The cube about any sample without a leaf meets no triangle.
  result.clearance.assign(field.distance.size(), static_cast<float>(0.50001 * h));
  for (const DistanceOctree::Leaf& leaf : octree.leaves())
  {
    const auto& [i, j, k] = leaf.cell.corner;
    const GridIndex sample = grid.index(i, j, k);
    const double distance = std::sqrt(leaf.squaredDistance);
    field.freeze(sample, static_cast<float>(distance / h));
    result.triangle[at(sample)] = leaf.triangle;
    result.clearance[at(sample)] = static_cast<float>(distance);
  }
  if (!containsAll(grid, tree.bounds()))
  {
    freezeBoundary(field, tree, grid, execution.phase(0.4, 0.6));
  }
  sweep(field, numberOfSweeps, execution.phase(0.6, 1.0));
  result.distance = std::move(field.distance);
  for (float& distance : result.distance)
  {
    distance = static_cast<float>(h * static_cast<double>(distance));
  }
  return result;
}

} // namespace evolving
