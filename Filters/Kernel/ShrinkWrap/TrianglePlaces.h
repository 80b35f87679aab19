// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A few places that stand for a whole triangle.
 */

#ifndef EVOLVING_TRIANGLE_PLACES_H
#define EVOLVING_TRIANGLE_PLACES_H

#include "Trees/TriangleGeometry.h"
#include "Types.h"

#include <array>

namespace evolving
{

/// The corners, the middles of the edges and the centroid.
inline std::array<Vec3, 7> placesOf(const Triangle& t)
{
  const auto& [a, b, c] = t.corners;
  return { a, b, c, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a), (a + b + c) / 3.0 };
}

} // namespace evolving

#endif
