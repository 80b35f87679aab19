// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Inside is what a flood from outside does not reach (section 5.4 of the thesis).
 */

#ifndef EVOLVING_FLOOD_FILL_H
#define EVOLVING_FLOOD_FILL_H

#include "Distance/DistanceGrid.h"
#include "Execution.h"
#include "Types.h"

#include <functional>
#include <vector>

namespace evolving
{

/// What the flood needs to know of the surface.
struct FloodFillQueries
{
  /// Is the sample so close to the surface that the flood may have missed it?
  std::function<bool(GridIndex)> isNearSurface;
  /// The side of such a sample, from the pseudonormal at its closest point.
  std::function<bool(GridIndex)> isBehindSurface;
  /// The side of a sample on the grid's faces; empty when the grid contains the surface, so
  /// that all of them are outside.
  std::function<bool(GridIndex)> isInside;
};

/**
 * Two neighbouring samples lie on the same side when their distances to the surface sum up to
 * more than their spacing, for a crossing between them could be no farther from both. The flood
 * runs through such pairs: first from the samples on the six faces of the grid, then, as
 * inside, from what is left away from the surface. What remains is so close to the surface that
 * its distances say nothing: inside when only samples inside are around it, or when it is behind
 * the surface.
 * The thesis floods from one corner through samples whose cells the surface does not meet, a
 * special case of this.
 *
 * A hollow space inside the surface counts as inside, whatever bounds it.
 * @param clearance a lower bound for the distance of each sample to the surface
 * @return not 0 for samples inside
 * @throws Cancelled
 */
std::vector<char> floodFill(const DistanceGrid& grid, const std::vector<float>& clearance,
  const FloodFillQueries& queries, const Execution& execution = {});

} // namespace evolving

#endif
