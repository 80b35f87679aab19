// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which samples are inside: the choice of a method and the methods.
 */

#ifndef EVOLVING_INSIDE_OUTSIDE_H
#define EVOLVING_INSIDE_OUTSIDE_H

#include "Distance/DistanceGrid.h"
#include "Distance/DistanceTarget.h"
#include "Distance/SignedDistanceOptions.h"
#include "Distance/UnsignedDistance.h"
#include "Execution.h"

#include <string>
#include <vector>

namespace evolving
{

struct SignChoice
{
  SignMethod method = SignMethod::Unsigned; ///< never Automatic
  std::string reason;                       ///< one sentence for the user
};

/**
 * The method asked for, or, for Automatic: the pseudonormal for a closed surface whose components
 * are apart and that does not cut through itself, the winding number for any other surface (holes,
 * edges of three faces, one-sided, intersecting or nested components), unsigned for points. Never a
 * method that needs the whole grid.
 * @throws InputError when points are asked for an inside
 * @throws Cancelled
 */
SignChoice chooseSignMethod(
  SignMethod asked, const DistanceTarget& target, const Execution& execution = {});

/**
 * @param method not Automatic
 * @param samples triangles known beside the surface for Pseudonormal (all of them for surfaces for
 * which needsTrianglesNearSurfaceOnly() is false) and for FloodFill, none for WindingNumber
 * @return not 0 for the samples of the grid that are inside
 * @throws Cancelled
 */
std::vector<char> samplesInside(SignMethod method, const DistanceTarget& target,
  const DistanceGrid& grid, const UnsignedDistance& samples, const Execution& execution = {});

} // namespace evolving

#endif
