// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * From any mesh or point set to an evolution that ends on it: the target, the start surface and
 * the parameters of the flow, chosen from the model.
 */

#ifndef EVOLVING_SHRINK_WRAP_H
#define EVOLVING_SHRINK_WRAP_H

#include "Evolution/FlowOptions.h"
#include "Evolution/ScalarImage.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "ShrinkWrap/ShrinkWrapOptions.h"
#include "ShrinkWrap/SurfaceReport.h"
#include "ShrinkWrap/WrapReference.h"
#include "ShrinkWrap/WrapRemesher.h"
#include "ShrinkWrap/WrapResolution.h"
#include "ShrinkWrap/WrapTarget.h"
#include "ShrinkWrap/WrapTuning.h"

#include <cstddef>
#include <memory>

namespace evolving
{

/// An evolution that is ready to run; its last state is the finished surface.
struct ShrinkWrapProblem
{
  std::shared_ptr<const SurfaceMesh> start; ///< without self-intersections
  std::shared_ptr<const ScalarImage> field; ///< zero where the result shall lie
  std::shared_ptr<WrapRemesher> remesher;
  FlowOptions flow;                               ///< in absolute units
  std::shared_ptr<const WrapReference> reference; ///< where the result shall lie, exactly
  double edgeLength = 0.0;                        ///< of the result
  double modelSize = 0.0; ///< the diagonal of the box that the result should fill
  std::shared_ptr<const WrapTarget> target;
  ShrinkWrapOptions options;
  bool keepsTopology = false; ///< of the target: not of points, nor where holes are to be closed
};

/**
 * Bytes for each sample that prepareShrinkWrap() holds at its peak, on a ball of 100^3 samples: the
 * distance to the target, the samples that balls come to, what signedDistance() needs for the
 * distance to their boundary, and the boundary itself. That counts more where balls come to both
 * sides of a surface (14 bytes there), and less and less on larger grids.
 */
int wrapBytesPerSample();

/**
 * @param mesh the target: triangles in any state, or points only; not empty
 * @throws InputError for a target without extent or area, coordinates that are not finite, options
 * out of range, or ones that ask for more vertices than requireFewVertices() lets pass
 * @throws Cancelled
 */
ShrinkWrapProblem prepareShrinkWrap(const SurfaceMesh& mesh, const ShrinkWrapOptions& options,
  const Execution& execution = {}, const WrapTuning& tuning = {});

/// What a problem holds in memory for its flow, the start aside.
std::size_t bytesOf(const ShrinkWrapProblem& problem);

/**
 * What was reached of a problem, but for SurfaceReport::lost, which elements alone decide.
 * @param surface its last state, as it is handed out
 * @throws Cancelled
 */
SurfaceReport measureWrap(
  const SurfaceMesh& surface, const ShrinkWrapProblem& problem, const Execution& execution = {});

/// All of it, likewise.
SurfaceReport examineWrap(
  const SurfaceMesh& surface, const ShrinkWrapProblem& problem, const Execution& execution = {});

} // namespace evolving

#endif
