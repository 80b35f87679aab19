// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Angles between vectors, and their units.
 */

#ifndef EVOLVING_ANGLES_H
#define EVOLVING_ANGLES_H

#include "Types.h"

#include <cmath>

namespace evolving
{

constexpr double Pi = 3.14159265358979323846;
constexpr double RadiansPerDegree = 0.017453292519943295;
constexpr double DegreesPerRadian = 57.29577951308232;

/// In radians, from 0 to pi; exact to rounding, even near 0 and pi. 0 when a vector vanishes.
inline double angleBetween(const Vec3& a, const Vec3& b)
{
  const double sine = a.cross(b).norm();
  const double cosine = a.dot(b);
  return sine == 0.0 && cosine == 0.0 ? 0.0 : std::atan2(sine, cosine); // atan2(0, -0) is pi
}

/// Falls as the angle between two vectors grows, and costs no inverse function: infinite where they
/// have the same direction or one vanishes, negative infinite where they have opposite ones.
inline double cotangentBetween(const Vec3& a, const Vec3& b)
{
  const double cosine = a.dot(b);
  const double sine = a.cross(b).norm();
  const double straight = cosine < 0.0 ? -HUGE_VAL : HUGE_VAL;
  return sine > 0.0 ? cosine / sine : straight;
}

} // namespace evolving

#endif
