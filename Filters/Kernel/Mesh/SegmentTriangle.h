// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Whether a segment meets a triangle. Exact.
 */

#ifndef EVOLVING_SEGMENT_TRIANGLE_H
#define EVOLVING_SEGMENT_TRIANGLE_H

#include "Types.h"

#include <array>

namespace evolving
{

using TriangleCorners = std::array<Vec3, 3>;

/**
 * Whether the segment pq and a triangle with area have a point in common; both are closed.
 * @param pSide orientation(t[0], t[1], t[2], p), which callers know already
 * @param qSide orientation(t[0], t[1], t[2], q)
 */
bool segmentMeetsTriangle(
  const Vec3& p, const Vec3& q, int pSide, int qSide, const TriangleCorners& t);

} // namespace evolving

#endif
