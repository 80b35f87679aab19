// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Gaps closed on a grid of distances, by a morphological closing.
 */

#ifndef EVOLVING_GAP_CLOSING_H
#define EVOLVING_GAP_CLOSING_H

#include "Distance/DistanceGrid.h"
#include "Execution.h"

#include <vector>

namespace evolving
{

/**
 * A field that is below zero within `offset` of a surface, and wherever a ball whose diameter is
 * the gap size cannot come from outside without touching the surface: behind slots, cracks and
 * openings narrower than the gap size, and in the solids that are closed then. Elsewhere zero lies
 * where distance == offset, as if there were no gap size; only concave edges are rounded.
 *
 * It is the closing of the solid within the offset: the centres of such balls that the outside is
 * joined to are bounded by an iso-surface (Isosurface.h), and from there the solid begins
 * gapSize / 2 - offset farther in. Zero is second order accurate in the spacing where both
 * distances are smooth. Beyond two cells from it the values are only sure in sign.
 *
 * Two things follow. Where an opening is as wide as the gap size to within two cells, it may close
 * or not: choose a gap size clearly above the gaps. And a short passage that balls from both its
 * ends rest on, as the hole of a ring, stays open while the balls overlap in it: through a thin
 * sheet, holes close that are narrower than 2 sqrt(offset (gapSize - offset)).
 * @param distance from the surface, one finite value per sample; without sign, or negative inside
 * @param offset not negative
 * @param gapSize when at most twice the offset, no more closes than the offset does, and the
 * result is distance - offset
 * @param grid with room for gapSize / 2 and a cell around the surface
 * @throws InputError when a length is negative or not finite, or field and grid do not fit
 * @throws Cancelled
 */
std::vector<float> closeGaps(const DistanceGrid& grid, const std::vector<float>& distance,
  double offset, double gapSize, const Execution& execution = {});

} // namespace evolving

#endif
