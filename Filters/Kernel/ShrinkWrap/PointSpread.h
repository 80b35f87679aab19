// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Whether points lie so that a surface amidst them can bound something.
 */

#ifndef EVOLVING_POINT_SPREAD_H
#define EVOLVING_POINT_SPREAD_H

#include "Mesh/SurfaceMesh.h"

namespace evolving
{

/// The points in their order, each once.
SurfaceMesh differentPoints(const SurfaceMesh& points);

/// @param points all different
/// @throws InputError for fewer than four points, and for points on a line
void requireExtent(const SurfaceMesh& points);

} // namespace evolving

#endif
