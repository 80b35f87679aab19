// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The parts of a closed surface that bound it towards the outside.
 */

#ifndef EVOLVING_OUTER_PARTS_H
#define EVOLVING_OUTER_PARTS_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"

namespace evolving
{

/**
 * The connected parts that lie in no other one, each turned so that its faces point outwards: of a
 * hollow ball the outer sphere. All points are kept.
 * @param surface triangles, closed and oriented, that does not intersect itself
 * @throws Cancelled
 */
SurfaceMesh outerParts(const SurfaceMesh& surface, const Execution& execution = {});

} // namespace evolving

#endif
