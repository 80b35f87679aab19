// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Edges of no length worth mentioning.
 */

#ifndef EVOLVING_SHORT_EDGES_H
#define EVOLVING_SHORT_EDGES_H

#include "Mesh/SurfaceMesh.h"

namespace evolving
{

/**
 * With edges shorter than some length collapsed; a closed surface that this would pinch stays.
 * @param surface triangles, welded
 */
SurfaceMesh withoutShortEdges(const SurfaceMesh& surface, double length);

} // namespace evolving

#endif
