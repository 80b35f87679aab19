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
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"

#include <string>
#include <vector>

namespace evolving
{

enum class DistanceMethod
{
  ClosestPoint = 0, ///< exact: blocks of samples searched together over a tree of boxes
  FastSweeping = 1, ///< section 5.3: octree cells frozen at their distance, Godunov sweeps
  BruteForce = 2,   ///< the reference: every sample by a query of the AABB tree, in double
};

enum class SignMethod
{
  Automatic = 0,
  FloodFill = 1,
  WindingNumber = 2,
  Pseudonormal = 3,
  Unsigned = 4,
};

struct SignedDistanceOptions
{
  DistanceMethod method = DistanceMethod::ClosestPoint;
  SignMethod sign = SignMethod::Automatic;
  double bandWidth = 0.0;      ///< in cells; 0 = the whole grid; beyond it the value is +-band
  double smoothingSigma = 0.0; ///< of a Gaussian, in cells; 0 = none
  int numberOfSweeps = 8;      ///< FastSweeping only
  bool closestPoint = false;   ///< fill DistanceResult::closestPoint
  bool closestFace = false;    ///< fill DistanceResult::closestFace
  bool gradient = false;       ///< fill DistanceResult::gradient
};

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

/// What a sample of the computed part costs at most, beyond the mesh, with its result copied once.
int peakBytesPerSample(const SignedDistanceOptions& options);

/// Can `part` be computed without the rest of the grid? Not with sweeps or flood fill.
bool canComputeParts(const SignedDistanceOptions& options);

} // namespace evolving

#endif
