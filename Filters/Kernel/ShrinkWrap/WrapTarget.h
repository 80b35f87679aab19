// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What shrink-wrapping has to know of its target: the distance to it, and the lengths that follow.
 */

#ifndef EVOLVING_WRAP_TARGET_H
#define EVOLVING_WRAP_TARGET_H

#include "Distance/DistanceGrid.h"
#include "Distance/SignedDistance.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "ShrinkWrap/ShrinkWrap.h"

namespace evolving
{

struct WrapTarget
{
  Box box;
  DistanceGrid grid;
  SignedDistanceResult distance; ///< without signs where the target has no inside
  double area = 0.0;             ///< of the target's faces, or of the surface around its points
  double edgeLength = 0.0;
  double wall = 0.0;   ///< half the thickness of a sheet without an inside; 0 with one
  double offset = 0.0; ///< of the start surface from the target

  double cellSize() const { return this->grid.spacing.maxCoeff(); }
};

/// @throws InputError as prepareShrinkWrap(). @throws Cancelled
WrapTarget describeTarget(
  const SurfaceMesh& mesh, const ShrinkWrapOptions& options, const Execution& execution);

} // namespace evolving

#endif
