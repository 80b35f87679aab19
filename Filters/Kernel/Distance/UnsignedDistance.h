// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The distance of samples before it has a sign, by each of the methods.
 */

#ifndef EVOLVING_UNSIGNED_DISTANCE_H
#define EVOLVING_UNSIGNED_DISTANCE_H

#include "Distance/DistanceGrid.h"
#include "Distance/DistanceTarget.h"
#include "Execution.h"
#include "Trees/AABBTree.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// One entry per sample of a grid.
struct UnsignedDistance
{
  std::vector<float> distance;
  std::vector<Index> triangle; ///< the closest one; NoIndex where not known
  /// A lower bound for the distance to the surface; empty where the distance itself is one.
  std::vector<float> clearance;

  const std::vector<float>& lowerBound() const
  {
    return this->clearance.empty() ? this->distance : this->clearance;
  }
};

/// The distances to triangles already known to be the closest. @throws Cancelled
UnsignedDistance distanceToTriangles(const SurfaceMesh& mesh, const DistanceGrid& grid,
  std::vector<Index> triangles, const Execution& execution = {});

/**
 * Section 5.3: the leaves of the octree frozen at their distance, then Godunov sweeps. Where
 * triangles lie outside the grid, the samples on its faces are frozen, too, at the distance the
 * tree gives. Triangles are known for the leaves only.
 * @param grid of cubes
 * @throws InputError when the grid is not cubic
 * @throws Cancelled
 */
UnsignedDistance distanceBySweeping(const AABBTree& tree, const DistanceGrid& grid,
  int numberOfSweeps, const Execution& execution = {});

} // namespace evolving

#endif
