// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A ray against triangles and boxes.
 */

#ifndef EVOLVING_RAY_H
#define EVOLVING_RAY_H

#include "Trees/TriangleGeometry.h"
#include "Types.h"

#include <array>
#include <optional>

namespace evolving
{

/// Where a ray crosses a triangle.
struct RayCrossing
{
  double parameter = 0.0; ///< >= 0
  bool isFromBehind = false;
};

/// Along no axis, which faces often lie along: for rays whose crossings are counted.
inline Vec3 askewDirection()
{
  return Vec3(0.5718, 0.3141, 0.7577);
}

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

  /// None when the ray does not cross the triangle.
  std::optional<RayCrossing> crossing(const Triangle& triangle) const;
  /// The parameter only.
  std::optional<double> hit(const Triangle& triangle) const
  {
    const std::optional<RayCrossing> found = this->crossing(triangle);
    return found ? std::optional<double>(found->parameter) : std::nullopt;
  }
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
