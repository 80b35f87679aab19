// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/FaceShape.h"

#include "Mesh/Angles.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

double faceShape(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const double area = (b - a).cross(c - a).norm(); // twice
  const double lengths = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return lengths > 0.0 ? 2.0 * std::sqrt(3.0) * area / lengths : 0.0;
}

double cosineOfSmallestAngle(const Vec3& a, const Vec3& b, const Vec3& c)
{
  // The smallest angle is opposite to the shortest side.
  const double ab = (b - a).squaredNorm();
  const double bc = (c - b).squaredNorm();
  const double ca = (a - c).squaredNorm();
  const double shortest = std::min({ ab, bc, ca });
  const double product = shortest == ab ? bc * ca : (shortest == bc ? ab * ca : ab * bc);
  return product > 0.0 ? (ab + bc + ca - 2.0 * shortest) / (2.0 * std::sqrt(product)) : 1.0;
}

double smallestAngle(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return std::acos(std::min(1.0, cosineOfSmallestAngle(a, b, c))) * DegreesPerRadian;
}

double cosineOfSmallestAngle(const EditableSurface& surface, Index face)
{
  return cosineOfSmallestAngle(
    surface.corner(face, 0), surface.corner(face, 1), surface.corner(face, 2));
}

double smallestAngle(const EditableSurface& surface, Index face)
{
  return smallestAngle(surface.corner(face, 0), surface.corner(face, 1), surface.corner(face, 2));
}

} // namespace evolving
