// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Patches too narrow for elements of a given size.
 */

#ifndef EVOLVING_NARROW_PATCHES_H
#define EVOLVING_NARROW_PATCHES_H

#include "Features/SharpEdges.h"
#include "Features/TargetTriangles.h"

namespace evolving
{

/**
 * Rule 2 of keepCarriable(): leaves out the edges between a patch narrower than a width and the
 * neighbour it belongs to, until none that has a neighbour is narrow. A patch's border is made of
 * the edges that it shares with other patches and of the surface's boundary, not of the darts
 * inside.
 * @return whether an edge was left out
 */
bool mergeNarrowPatches(const TargetTriangles& target, SharpEdges& sharp, double width);

} // namespace evolving

#endif
