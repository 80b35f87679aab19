// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * One triangle against a point and a box. Every function also accepts a triangle that is
 * a segment or a point.
 */

#ifndef EVOLVING_TRIANGLE_GEOMETRY_H
#define EVOLVING_TRIANGLE_GEOMETRY_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/// Three corners, counter-clockwise seen from outside.
struct Triangle
{
  std::array<Vec3, 3> corners;

  /// Twice the area times the unit normal; zero for a segment or a point.
  Vec3 doubleAreaNormal() const;
  Vec3 centroid() const { return (this->corners[0] + this->corners[1] + this->corners[2]) / 3.0; }
  Box box() const;
};

/// A face of a mesh of triangles.
inline Triangle triangleOf(const SurfaceMesh& mesh, Index face)
{
  return { { mesh.facePoint(face, 0), mesh.facePoint(face, 1), mesh.facePoint(face, 2) } };
}

/// All of them.
std::vector<Triangle> trianglesOf(const SurfaceMesh& mesh);

/// Where on a triangle a point lies. Edge k runs from corner k to corner k + 1.
enum class TriangleFeature : std::uint8_t
{
  Face = 0,
  Edge0 = 1,
  Edge1 = 2,
  Edge2 = 3,
  Vertex0 = 4,
  Vertex1 = 5,
  Vertex2 = 6,
};

struct TrianglePoint
{
  Vec3 point = Vec3::Zero();
  TriangleFeature feature = TriangleFeature::Face;
  double squaredDistance = 0.0;
};

/// Is a triangle so low, below 1e-8 of its longest edge, that its plane says nothing?
bool isDegenerate(const Triangle& triangle);

/**
 * The point of a triangle closest to a given one, by the Voronoi regions of its features
 * (Ericson, Real-Time Collision Detection, 2005, 5.1.5). A degenerate triangle is
 * taken as its three edges.
 */
TrianglePoint closestPointOnTriangle(const Vec3& point, const Triangle& triangle);

/**
 * Do a triangle and a closed box have a point in common? Exact to rounding: 13 separating axes
 * (Akenine-Moeller, Fast 3D Triangle-Box Overlap Testing, 2001).
 */
bool overlaps(const Triangle& triangle, const Box& box);

} // namespace evolving

#endif
