// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * From a mesh or points to a signed distance grid: the parts of this folder put together
 * (chapter 5 of the thesis, algorithm 6).
 */

#ifndef EVOLVING_SIGNED_DISTANCE_H
#define EVOLVING_SIGNED_DISTANCE_H

#include "Distance/DistanceGrid.h"
#include "Distance/SignedDistanceOptions.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"

#include <string>
#include <vector>

namespace evolving
{

/// One entry per sample of the asked extent, x fastest.
struct SignedDistanceResult
{
  std::vector<float> distance;     ///< negative inside
  std::vector<float> closestPoint; ///< 3 per sample, when asked for
  std::vector<Index> closestFace;  ///< face of the mesh (point of a point set), when asked for
  std::vector<float> gradient;     ///< 3 per sample, unit length or zero, when asked for
  SignMethod sign = SignMethod::Unsigned; ///< the method used; never Automatic
  std::string signReason;                 ///< one sentence for the user
};

/**
 * Signed distance from a triangle mesh, or unsigned distance from the points of a mesh without
 * faces, at the samples of `part` of `grid`.
 * The mesh may be any soup: welding is done inside, faces keep their numbers in closestFace.
 * @throws InputError for options that do not fit together or a mesh that cannot be used
 * @throws Cancelled
 */
SignedDistanceResult signedDistance(const SurfaceMesh& mesh, const DistanceGrid& grid,
  const Extent& part, const SignedDistanceOptions& options, const Execution& execution = {});

/// The most bytes that a sample of the computed part takes, beyond the mesh: all its values while
/// it is computed, and the copy of those that are handed out.
int peakBytesPerSample(const SignedDistanceOptions& options);

/// Can `part` be computed without the rest of the grid? Not with sweeps or flood fill.
bool canComputeParts(const SignedDistanceOptions& options);

} // namespace evolving

#endif
