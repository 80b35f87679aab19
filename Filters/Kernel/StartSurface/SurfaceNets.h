// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Naive surface nets (Gibson 1998) between inside and outside samples.
 */

#ifndef EVOLVING_SURFACE_NETS_H
#define EVOLVING_SURFACE_NETS_H

#include "Distance/DistanceGrid.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "StartSurface/InsideSamples.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// A mesh of quads with one vertex in each of some cells of a grid.
struct SurfaceNet
{
  SurfaceMesh mesh;
  std::vector<Box> cellOfVertex; ///< the cell's box, in the grid's space
};

/**
 * One vertex per cell with inside and outside corners, at the mean of the points where the field
 * crosses the cell's edges; one quad per crossed grid edge, seen counter-clockwise from outside.
 * Closed whatever the samples are, and 2-manifold when they are well-composed. Crossings keep
 * 1/50 of a cell's edge away from its ends, so that no two vertices coincide.
 * @param samples on the same grid
 * @throws Cancelled
 */
SurfaceNet surfaceNet(
  const DistanceGrid& grid, const InsideSamples& samples, const Execution& execution = {});

/**
 * Moves every vertex to the mean of its neighbours, `sweeps` times, all at once in each sweep,
 * but never out of its cell (nor nearer to the cell's sides than 1/50 of its length).
 * @throws Cancelled
 */
void relaxWithinCells(SurfaceNet& net, int sweeps, const Execution& execution = {});

} // namespace evolving

#endif
