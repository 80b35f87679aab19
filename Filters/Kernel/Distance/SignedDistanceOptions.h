// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The parameters of a signed distance grid.
 */

#ifndef EVOLVING_SIGNED_DISTANCE_OPTIONS_H
#define EVOLVING_SIGNED_DISTANCE_OPTIONS_H

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
  bool closestPoint = false;   ///< fill SignedDistanceResult::closestPoint
  bool closestFace = false;    ///< fill SignedDistanceResult::closestFace
  bool gradient = false;       ///< fill SignedDistanceResult::gradient
};

} // namespace evolving

#endif
