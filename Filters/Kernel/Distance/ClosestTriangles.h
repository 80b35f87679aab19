// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The closest triangle of every sample of a grid, by one query of the tree each.
 */

#ifndef EVOLVING_CLOSEST_TRIANGLES_H
#define EVOLVING_CLOSEST_TRIANGLES_H

#include "Distance/DistanceGrid.h"
#include "Execution.h"
#include "Trees/AABBTree.h"
#include "Types.h"

#include <functional>
#include <vector>

namespace evolving
{

/// Called with a sample's number in the grid's arrays and its position.
using SampleVisit = std::function<void(GridIndex sample, const Vec3& point)>;

/**
 * Visits every sample of a grid, rows in parallel, each along x.
 * @throws Cancelled
 */
void forEachSample(const DistanceGrid& grid, const Execution& execution, const SampleVisit& visit);

/**
 * @param tree not empty
 * @return one triangle per sample, the same for a sample whatever the rest of the grid
 * @throws Cancelled
 */
std::vector<Index> queryClosestTriangles(
  const AABBTree& tree, const DistanceGrid& grid, const Execution& execution = {});

/**
 * The same for the samples on the faces of the grid's box only; NoIndex inside. From any
 * triangle outside the box the way to a sample inside leads past one of these.
 */
std::vector<Index> queryBoundaryTriangles(
  const AABBTree& tree, const DistanceGrid& grid, const Execution& execution = {});

/**
 * The points of given triangles closest to the samples, moved by an offset.
 * @param triangles one per sample
 * @return three numbers per sample
 * @throws Cancelled
 */
std::vector<float> closestPoints(const SurfaceMesh& mesh, const DistanceGrid& grid,
  const std::vector<Index>& triangles, const Vec3& offset, const Execution& execution = {});

/// Does the box of the samples contain that of a surface?
bool containsAll(const DistanceGrid& grid, const Box& surface);

} // namespace evolving

#endif
