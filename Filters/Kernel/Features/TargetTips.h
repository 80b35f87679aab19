// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The tips of a target's spikes and cones.
 */

#ifndef EVOLVING_TARGET_TIPS_H
#define EVOLVING_TARGET_TIPS_H

#include "Features/TargetTriangles.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * The vertices amidst triangles, none of whose edges there has another number of faces than two,
 * that are more pointed than a corner of a regular tetrahedron, with creases or, as on a cone,
 * without: around them there are less than 180 degrees. Ascending.
 */
std::vector<Index> tipsOf(const TargetTriangles& target);

} // namespace evolving

#endif
