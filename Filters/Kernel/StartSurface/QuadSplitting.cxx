// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/QuadSplitting.h"

#include "Mesh/Angles.h"
#include <algorithm>
#include <array>
#include <cmath>

namespace evolving
{

namespace
{

/// Angles and folds in radians that differ by less are equal.
constexpr double AngleTolerance = 1e-6;

double smallestTriangleAngle(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return std::min(
    { angleBetween(b - a, c - a), angleBetween(c - b, a - b), angleBetween(a - c, b - c) });
}

/// A quad split from corner 0 to corner 2.
struct Split
{
  double smallestAngle;
  double fold; ///< the angle between the two triangles' normals

  explicit Split(const std::array<Vec3, 4>& p)
    : smallestAngle(
        std::min(smallestTriangleAngle(p[0], p[1], p[2]), smallestTriangleAngle(p[0], p[2], p[3])))
    , fold(angleBetween(
        (p[1] - p[0]).cross(p[2] - p[0]).eval(), (p[2] - p[0]).cross(p[3] - p[0]).eval()))
  {
  }

  bool isWorseThan(const Split& other) const
  {
    if (std::abs(this->smallestAngle - other.smallestAngle) > AngleTolerance)
    {
      return this->smallestAngle < other.smallestAngle;
    }
    return this->fold > other.fold + AngleTolerance;
  }
};

void addSplitQuad(const SurfaceMesh& mesh, Index face, SurfaceMesh& triangles)
{
  std::array<Vec3, 4> points;
  std::array<Vec3, 4> turned;
  for (Index k = 0; k < 4; ++k)
  {
    points[static_cast<std::size_t>(k)] = mesh.facePoint(face, k);
    turned[static_cast<std::size_t>(k)] = mesh.facePoint(face, (k + 1) % 4);
  }
  const Index first = Split(points).isWorseThan(Split(turned)) ? 1 : 0;
  const auto vertex = [&](Index k) { return mesh.faceVertex(face, (first + k) % 4); };
  triangles.addFace({ vertex(0), vertex(1), vertex(2) });
  triangles.addFace({ vertex(0), vertex(2), vertex(3) });
}

} // namespace

SurfaceMesh splitQuads(const SurfaceMesh& mesh)
{
  SurfaceMesh triangles;
  triangles.points = mesh.points;
  triangles.faceOffsets.reserve(2 * mesh.faceOffsets.size());
  triangles.cornerVertices.reserve(mesh.cornerVertices.size() / 4 * 6);
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    if (mesh.faceSize(face) == 4)
    {
      addSplitQuad(mesh, face, triangles);
      continue;
    }
    const auto corners = mesh.cornerVertices.begin();
    const auto f = static_cast<std::size_t>(face);
    triangles.addFace(
      std::vector<Index>(corners + mesh.faceOffsets[f], corners + mesh.faceOffsets[f + 1]));
  }
  return triangles;
}

} // namespace evolving
