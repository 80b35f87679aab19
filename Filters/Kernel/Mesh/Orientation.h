// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * On which side a point lies, decided without rounding errors.
 *
 * Only the signs of determinants, but these always right: a filter in double precision decides
 * nearly always, exact arithmetic what remains (Shewchuk 1997). The products of three coordinates
 * must neither overflow nor come near the smallest double.
 */

#ifndef EVOLVING_ORIENTATION_H
#define EVOLVING_ORIENTATION_H

#include "Types.h"

namespace evolving
{

/**
 * The sign of (b - a) x (c - a) . (d - a): 1 when d lies on the side of the plane abc from which
 * a, b, c run counter-clockwise, -1 on the other side, 0 in the plane.
 */
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/**
 * The same in the plane that remains when a coordinate axis (0, 1 or 2) is dropped: 1 when a, b, c
 * run counter-clockwise seen from the end of that axis, 0 on a line.
 */
int planarOrientation(int axis, const Vec3& a, const Vec3& b, const Vec3& c);

} // namespace evolving

#endif
