// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The numbers that describe a state of the evolution.
 */

#ifndef EVOLVING_STATE_MEASURES_H
#define EVOLVING_STATE_MEASURES_H

#include "Evolution/FlowState.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"

namespace evolving
{

/**
 * Fills in area, volume, mean and largest |d| (0 without distances; the mean is over the
 * surface) and the smallest corner angle in degrees. Leaves the other numbers.
 * @param center that the volume of an open surface is measured from
 * @param arrays coVolume and distance are read
 */
void measureState(const SurfaceMesh& mesh, const Vec3& center, const StateArrays& arrays,
  FlowRecord& record, const Execution& execution);

/// How far the vertex that moved farthest along its normal did. @param normals one per vertex
double farthestNormalMove(const std::vector<Vec3>& before, const std::vector<Vec3>& after,
  const std::vector<Vec3>& normals);

} // namespace evolving

#endif
