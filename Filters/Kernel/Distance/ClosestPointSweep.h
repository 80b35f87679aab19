// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The closest triangle of every sample of a grid by propagation: exact beside the surface, from
 * there outwards a sample tries the triangles of its neighbours.
 */

#ifndef EVOLVING_CLOSEST_POINT_SWEEP_H
#define EVOLVING_CLOSEST_POINT_SWEEP_H

#include "Distance/AABBTree.h"
#include "Distance/DistanceGrid.h"
#include "Execution.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * Four stages:
 * - samples at most two cells away from the surface get their triangle by drawing all triangles
 *   into the grid; when triangles lie outside the grid, the samples on its faces get theirs by
 *   queries of the tree;
 * - four sweeps, in which a row takes triangles over from three rows before it and then along
 *   itself in both directions;
 * - every sample walks over the mesh, from its triangle to the closest of those that touch it;
 * - every sample tries the triangles of the 26 samples around it; then twice both again around
 *   the samples for which that changed something.
 * The idea is Tsai's (Rapid and Accurate Computation of the Distance Function Using Grids,
 * 2002) and of SDFGen (Bridson, Batty). A sample's triangle is always a real one, so distances
 * are never too small; they are too large by less than a thousandth of a cell in the mean and
 * by some hundredths at single samples more than two cells away from the surface.
 *
 * @param mesh the triangles the tree was built from, not none
 * @return one triangle per sample
 * @throws Cancelled
 */
std::vector<Index> sweepClosestTriangles(const SurfaceMesh& mesh, const AABBTree& tree,
  const DistanceGrid& grid, const Execution& execution = {});

} // namespace evolving

#endif
