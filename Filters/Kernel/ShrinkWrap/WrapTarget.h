// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What shrink-wrapping has to know of its target: the surface to lie on, the distance to it, and
 * the lengths that follow.
 */

#ifndef EVOLVING_WRAP_TARGET_H
#define EVOLVING_WRAP_TARGET_H

#include "Distance/DistanceGrid.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "ShrinkWrap/ShrinkWrapOptions.h"
#include "ShrinkWrap/WrapTuning.h"

#include <vector>

namespace evolving
{

struct WrapTarget
{
  Box box;                 ///< of the input
  SurfaceMesh surface;     ///< triangles: the input's, and caps on its holes
  DistanceGrid grid;       ///< with room for the start surface
  double area = 0.0;       ///< of the surface
  double edgeLength = 0.0; ///< of the result
  double offset = 0.0;     ///< of the result from the surface
  double wall = 0.0;       ///< half the thickness of what becomes of sheets
  double startLevel = 0.0; ///< of the start from the surface
  WrapTuning tuning;

  double cellSize() const { return this->grid.spacing.maxCoeff(); }
  /// The size of elements that makes remeshing end with edges of edgeLength.
  double elementSize() const { return this->tuning.finish.shortening * this->edgeLength; }
  /// The diagonal of the box that the result should fill.
  double modelSize() const
  {
    return (this->box.sizes() + Vec3::Constant(2.0 * this->offset)).norm();
  }
};

/// Values at the samples of the target's grid: large, and soon of no more use.
struct TargetFields
{
  std::vector<float> distance; ///< from the surface, without sign
  std::vector<bool> isInside;  ///< as far as the target lets tell its sides
  std::vector<float> start; ///< zero on the start surface, gaps closed, negative towards the target
};

struct DescribedTarget
{
  WrapTarget target;
  TargetFields fields;
};

/**
 * @param mesh triangles in any state, or points only; not empty
 * @throws InputError for a target without extent or area, coordinates that are not finite, or
 * options out of range
 * @throws Cancelled
 */
DescribedTarget describeTarget(const SurfaceMesh& mesh, const ShrinkWrapOptions& options,
  const Execution& execution, const WrapTuning& tuning = {});

} // namespace evolving

#endif
