// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which samples of a grid are inside, by the winding number.
 */

#ifndef EVOLVING_WINDING_SIGN_H
#define EVOLVING_WINDING_SIGN_H

#include "Distance/DistanceGrid.h"
#include "Distance/DistanceTarget.h"
#include "Execution.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// A point is inside where the winding number is larger.
constexpr double WindingThreshold = 0.5;

/**
 * The winding number at every sample, evaluated only where it may have passed the threshold unseen
 * since it was last. Along a row of samples it changes by one at each crossing of the surface, and
 * these a ray finds; besides only by the field of the surface's open edges (OpenEdgeField). Where
 * that may be too much, it is a whole number, which crossings of the surface and its caps change
 * (OpenEdgeCaps.h), less the winding number of the few caps.
 * @param clearance a lower bound for the distance of each sample to the surface
 * @return not 0 for samples inside: as if evaluated at every one
 * @throws Cancelled
 */
std::vector<char> insideByWindingNumber(const DistanceTarget& target, const DistanceGrid& grid,
  const std::vector<float>& clearance, const Execution& execution = {});

} // namespace evolving

#endif
