// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which creases elements of a given size can carry.
 */

#ifndef EVOLVING_CARRIABLE_FEATURES_H
#define EVOLVING_CARRIABLE_FEATURES_H

#include "Execution.h"
#include "Features/SharpEdges.h"
#include "Features/TargetTriangles.h"

namespace evolving
{

/**
 * Leaves sharp edges out until none of these is left, elements having edges of length L:
 *
 * 1. a crease, with all that is connected to it, of less than 2 L in all; and a curve shorter
 *    than L with a loose end;
 * 2. a patch narrower than 0.7 L (area over half its border's length, 0.7 of the width of a strip
 *    and of a disc's radius): the narrowest first, it is merged with a neighbour. Of the
 *    neighbours that share at least half as much border as the longest one, this is the one
 *    behind the weakest fold; of those within 5 degrees of it the largest; of those within a tenth
 *    of that the one with the smallest triangle;
 * 3. a curve of which more than half runs within 0.7 L of others at the same patch, corners that
 *    both share left aside: the weakest first (by fold, then the shorter).
 *
 * So a chamfer of 0.3 L becomes one crease, a fillet of narrow strips one or two at a distance
 * that elements can fill, a thin plate's rim one edge, and a scan's rough places none.
 * @param edgeLength L, in the target's unit; 0 keeps all
 * @throws Cancelled
 */
void keepCarriable(const TargetTriangles& target, SharpEdges& sharp, double edgeLength,
  const Execution& execution = {});

/// The width below which a strip between two creases cannot be filled, over L.
constexpr double LeastCarriableWidth = 0.7;
/// Folds that differ by less, in degrees, are equally strong.
constexpr double SimilarFold = 5.0;
/// Areas and lengths that differ by less, relatively, are equal.
constexpr double SimilarSize = 0.1;

} // namespace evolving

#endif
