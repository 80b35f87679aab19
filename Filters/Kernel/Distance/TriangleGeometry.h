// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * One triangle against a point, a box and a ray. Every function also accepts a triangle that is
 * a segment or a point.
 */

#ifndef EVOLVING_TRIANGLE_GEOMETRY_H
#define EVOLVING_TRIANGLE_GEOMETRY_H

#include "Types.h"

#include <array>
#include <optional>

namespace evolving
{

/// Three corners, counter-clockwise seen from outside.
struct Triangle
{
  std::array<Vec3, 3> corners;

  /// Twice the area times the unit normal; zero for a segment or a point.
  Vec3 doubleAreaNormal() const;
  Box box() const;
};

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

/**
 * A ray prepared for many triangles (Woop, Benthin, Wald, Watertight Ray/Triangle Intersection,
 * 2013). A ray through an edge shared by two triangles hits exactly one of them if it passes
 * from one to the other, so that the parity of the hits is that of the crossings.
 */
class Ray
{
public:
  /// @param direction not zero; its length is the unit of the ray's parameter
  Ray(const Vec3& origin, const Vec3& direction);

  /// The parameter, >= 0, at which the ray crosses the triangle; none when it does not.
  std::optional<double> hit(const Triangle& triangle) const;
  /// Does the ray meet a closed box?
  bool meets(const Box& box) const;

private:
  Vec3 Origin;
  Vec3 Direction;
  std::array<int, 3> Axes; ///< the last one is the direction's longest
  Vec3 Shear;
};

} // namespace evolving

#endif
