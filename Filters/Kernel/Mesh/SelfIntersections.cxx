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

void requireTriangles(const SurfaceMesh& mesh)
{
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    if (mesh.faceSize(face) != 3)
    {
      std::ostringstream message;
      message << "Face " << face << " has " << mesh.faceSize(face)
              << " corners, expected 3 to look for self-intersections; triangulate the mesh first.";
      throw InputError(message.str());
    }
  }
}

/// The points times a power of two, which changes no digit, so that products stay in range.
std::vector<Vec3> pointsOfUnitSize(const SurfaceMesh& mesh)
{
  const Box box = boundingBox(mesh);
  const double size = box.isEmpty()
    ? 0.0
    : std::max(box.min().lpNorm<Eigen::Infinity>(), box.max().lpNorm<Eigen::Infinity>());
  const int exponent = size > 0.0 ? std::ilogb(size) : 0;
  std::vector<Vec3> points = mesh.points;
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
  validate(triangles);
  requireTriangles(triangles);
  const std::vector<Vec3> points = pointsOfUnitSize(triangles);
  const auto vertices = [&](Index face) -> TriangleVertices
  {
    return { triangles.faceVertex(face, 0), triangles.faceVertex(face, 1),
      triangles.faceVertex(face, 2) };
  };
  std::vector<Box> boxes(static_cast<std::size_t>(triangles.faceCount()));
  for (Index face = 0; face < triangles.faceCount(); ++face)
  {
    if (hasArea(points, vertices(face)))
    {
      for (const Index vertex : vertices(face))
      {
        boxes[static_cast<std::size_t>(face)].extend(points[static_cast<std::size_t>(vertex)]);
      }
    }
  }
  return overlappingPairs(
    boxes,
    [&](Index first, Index second)
    { return intersectBeyondShared(points, vertices(first), vertices(second)); },
    execution);
}

} // namespace evolving
