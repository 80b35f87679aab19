// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which samples of a grid are behind the surface, by pseudonormals where the surface is close.
 */

#ifndef EVOLVING_PSEUDONORMAL_SIGN_H
#define EVOLVING_PSEUDONORMAL_SIGN_H

#include "Distance/DistanceGrid.h"
#include "Distance/DistanceTarget.h"
#include "Distance/UnsignedDistance.h"
#include "Execution.h"

#include <vector>

namespace evolving
{

/// Is it enough to know the closest triangles of samples beside the surface? Not of a surface
/// that has an edge or meets itself: what is behind it may change away from it.
bool needsTrianglesNearSurfaceOnly(const OrientationSummary& surface);

/**
 * Two neighbouring samples whose distances to a closed surface sum up to more than their spacing
 * lie on the same side. So a side is found once, by the pseudonormal at the closest point, and
 * carried on along a row, and from row to row, until the surface is near. Where a sample near the
 * surface contradicts what was carried to it, as beside a surface that cuts through itself, the
 * whole row is taken sample by sample.
 * @return not 0 for samples inside
 * @throws Cancelled
 */
std::vector<char> insideByPseudonormal(const DistanceTarget& target, const DistanceGrid& grid,
  const UnsignedDistance& samples, const Execution& execution = {});

} // namespace evolving

#endif
