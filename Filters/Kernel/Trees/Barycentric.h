// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Where in a triangle a point lies.
 */

#ifndef EVOLVING_BARYCENTRIC_H
#define EVOLVING_BARYCENTRIC_H

#include "Trees/TriangleGeometry.h"
#include "Types.h"

namespace evolving
{

/// The weights of the corners, summing to 1, of a point in the plane of a triangle with area.
inline Vec3 barycentricCoordinates(const Triangle& triangle, const Vec3& point)
{
  const Vec3 normal = triangle.doubleAreaNormal();
  const Vec3 toPoint = point - triangle.corners[0];
  const double squared = normal.squaredNorm();
  const double b = toPoint.cross(triangle.corners[2] - triangle.corners[0]).dot(normal) / squared;
  const double c = (triangle.corners[1] - triangle.corners[0]).cross(toPoint).dot(normal) / squared;
  return { 1.0 - b - c, b, c };
}

} // namespace evolving

#endif
