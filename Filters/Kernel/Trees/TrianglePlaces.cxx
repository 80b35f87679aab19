// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Trees/TrianglePlaces.h"

#include "ParallelLoops.h"
#include "Trees/Barycentric.h"

#include <algorithm>

namespace evolving
{

namespace
{

/// Edge k runs from corner k to corner k + 1; one without length has its first corner alone.
Vec3 weightsOnEdge(const Triangle& triangle, int k, const Vec3& point)
{
  const int next = (k + 1) % 3;
  const auto& corners = triangle.corners;
  const Vec3 edge = corners[static_cast<std::size_t>(next)] - corners[static_cast<std::size_t>(k)];
  const double squared = edge.squaredNorm();
  const double along = (point - corners[static_cast<std::size_t>(k)]).dot(edge);
  const double t = squared > 0.0 ? std::clamp(along / squared, 0.0, 1.0) : 0.0;
  Vec3 weights = Vec3::Zero();
  weights[k] = 1.0 - t;
  weights[next] = t;
  return weights;
}

/// Rounding may put a place next to an edge a little outside.
Vec3 weightsInside(const Triangle& triangle, const Vec3& point)
{
  const Vec3 weights = barycentricCoordinates(triangle, point).cwiseMax(0.0);
  return weights / weights.sum();
}

Vec3 weightsOf(const TrianglePoint& at, const Triangle& triangle)
{
  switch (at.feature)
  {
    case TriangleFeature::Face:
      return weightsInside(triangle, at.point);
    case TriangleFeature::Edge0:
      return weightsOnEdge(triangle, 0, at.point);
    case TriangleFeature::Edge1:
      return weightsOnEdge(triangle, 1, at.point);
    case TriangleFeature::Edge2:
      return weightsOnEdge(triangle, 2, at.point);
    case TriangleFeature::Vertex1:
      return Vec3::UnitY();
    case TriangleFeature::Vertex2:
      return Vec3::UnitZ();
    default:
      return Vec3::UnitX();
  }
}

} // namespace

TrianglePlace closestPlace(const AABBTree& tree, const Vec3& point)
{
  const ClosestTriangle closest = tree.closest(point);
  return { closest.triangle, weightsOf(closest.at, tree.triangle(closest.triangle)) };
}

std::vector<TrianglePlace> closestPlaces(
  const AABBTree& tree, const std::vector<Vec3>& points, const Execution& execution)
{
  std::vector<TrianglePlace> places(points.size());
  forEachIndex(execution, static_cast<std::int64_t>(points.size()),
    [&](Index i)
    {
      const auto number = static_cast<std::size_t>(i);
      places[number] = closestPlace(tree, points[number]);
    });
  return places;
}

} // namespace evolving
