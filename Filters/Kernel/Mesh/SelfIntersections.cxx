// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/SelfIntersections.h"

#include "Errors.h"
#include "Mesh/BoxPairs.h"
#include "Mesh/TrianglePairs.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace evolving
{

namespace
{

/// The largest coordinate of the triangles' corners, without its sign.
double largestCoordinate(const TriangleView& triangles)
{
  double largest = 0.0;
  for (Index t = 0; t < triangles.count(); ++t)
  {
    for (const Index vertex : triangles.vertices(t))
    {
      const Vec3& point = triangles.points()[at(vertex)];
      if (!point.allFinite())
      {
        std::ostringstream message;
        message << "Vertex " << vertex << " is at (" << point.transpose()
                << "), expected finite coordinates to look for self-intersections; repair it.";
        throw InputError(message.str());
      }
      largest = std::max(largest, point.lpNorm<Eigen::Infinity>());
    }
  }
  return largest;
}

/// The points times a power of two, which changes no digit, so that products stay in range.
std::vector<Vec3> pointsOfUnitSize(const TriangleView& triangles)
{
  const double size = largestCoordinate(triangles);
  const int exponent = size > 0.0 ? std::ilogb(size) : 0;
  std::vector<Vec3> points = triangles.points();
  for (Vec3& point : points)
  {
    point = point.unaryExpr([exponent](double x) { return std::scalbn(x, -exponent); });
  }
  return points;
}

} // namespace

std::vector<std::pair<Index, Index>> selfIntersections(
  const SurfaceMesh& triangles, const Execution& execution)
{
  return selfIntersections(triangleView(triangles), execution);
}

std::vector<std::pair<Index, Index>> selfIntersections(
  const TriangleView& triangles, const Execution& execution)
{
  const std::vector<Vec3> points = pointsOfUnitSize(triangles);
  std::vector<Box> boxes(at(triangles.count()));
  for (Index t = 0; t < triangles.count(); ++t)
  {
    const TriangleVertices vertices = triangles.vertices(t);
    if (hasArea(points, vertices))
    {
      for (const Index vertex : vertices)
      {
        boxes[at(t)].extend(points[at(vertex)]);
      }
    }
  }
  return overlappingPairs(
    boxes,
    [&](Index first, Index second) {
      return intersectBeyondShared(points, triangles.vertices(first), triangles.vertices(second));
    },
    execution);
}

} // namespace evolving
