// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/FaceShape.h"

#include "Mesh/Angles.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// Between the two longer sides; its cosine is twiceDot / (2 sqrt(product)).
struct SmallestAngle
{
  double twiceDot;
  double product; ///< of the squared lengths of the sides

  // The smallest angle is opposite to the shortest side.
  SmallestAngle(const Vec3& a, const Vec3& b, const Vec3& c)
  {
    const double ab = (b - a).squaredNorm();
    const double bc = (c - b).squaredNorm();
    const double ca = (a - c).squaredNorm();
    const double shortest = std::min({ ab, bc, ca });
    this->product = shortest == ab ? bc * ca : (shortest == bc ? ab * ca : ab * bc);
    this->twiceDot = ab + bc + ca - 2.0 * shortest;
  }
};

} // namespace

double faceShape(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const double area = (b - a).cross(c - a).norm(); // twice
  const double lengths = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return lengths > 0.0 ? 2.0 * std::sqrt(3.0) * area / lengths : 0.0;
}

double cosineOfSmallestAngle(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const SmallestAngle angle(a, b, c);
  return angle.product > 0.0 ? angle.twiceDot / (2.0 * std::sqrt(angle.product)) : 1.0;
}

bool hasSmallerCosine(const Vec3& a, const Vec3& b, const Vec3& c, double limit)
{
  constexpr double Rounding = 1e-12;  // far above that of a dozen operations
  constexpr double Smallest = 1e-290; // of numbers with all their digits
  const SmallestAngle angle(a, b, c);
  const double square = angle.twiceDot * angle.twiceDot;
  const double ofLimit = 4.0 * limit * limit * angle.product;
  if (limit > 0.0 && ofLimit > Smallest && square > (1.0 + Rounding) * ofLimit)
  {
    return false;
  }
  if (limit > 0.0 && ofLimit > Smallest && square < (1.0 - Rounding) * ofLimit)
  {
    return true;
  }
  return cosineOfSmallestAngle(a, b, c) < limit;
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

double cosineOfSmallestAngleAround(const EditableSurface& surface, Index vertex)
{
  double worst = 0.0;
  surface.forEachOutgoing(vertex,
    [&](Index e)
    {
      worst = std::max(worst,
        cosineOfSmallestAngle(
          surface.point(vertex), surface.point(surface.to(e)), surface.point(surface.apex(e))));
    });
  return worst;
}

} // namespace evolving
