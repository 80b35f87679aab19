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

/// In radians, from 0 to pi; exact to rounding also near both. 0 when a vector vanishes.
inline double angleBetween(const Vec3& a, const Vec3& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

} // namespace evolving

#endif
