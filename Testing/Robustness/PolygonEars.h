// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Polygons into triangles by cutting ears off: the slow and simple way, for models and judges.
 */

#ifndef ROBUSTNESS_POLYGON_EARS_H
#define ROBUSTNESS_POLYGON_EARS_H

#include "Model.h"

namespace robustness
{

/// The triangles of a planar simple polygon; fewer than corners - 2 where it is none.
std::vector<Triangle> earsOf(const std::vector<Vec3>& points, const Cell& polygon);

/**
 * Whether a polygon is planar (to a part of its size that rounding cannot exceed) and simple, so
 * that whatever way it is cut, its triangles cover the same points.
 */
bool isPlanarAndSimple(const std::vector<Vec3>& points, const Cell& polygon);

} // namespace robustness

#endif
