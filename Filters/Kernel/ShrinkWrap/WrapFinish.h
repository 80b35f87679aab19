// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The last part of shrink-wrapping: a surface that has arrived becomes one of good elements, as
 * close to the target as their size allows.
 */

#ifndef EVOLVING_WRAP_FINISH_H
#define EVOLVING_WRAP_FINISH_H

#include "Execution.h"
#include "FeatureCapture/FeatureCoverage.h"
#include "Mesh/SurfaceMesh.h"
#include "Remeshing/IntersectionFreeStages.h"
#include "ShrinkWrap/ShrinkWrapOptions.h"
#include "ShrinkWrap/WrapReference.h"
#include "ShrinkWrap/WrapTarget.h"

namespace evolving
{

struct FinishedWrap
{
  SurfaceMesh surface; ///< without self-intersections: a stage that makes some is undone there
  FeatureCoverage creases;
  StageRuns adaptation; ///< ShrinkWrapOptions::adaptToCurvature
};

/**
 * @param surface near the target, without self-intersections
 * @throws Cancelled
 */
FinishedWrap finishWrap(const SurfaceMesh& surface, const WrapTarget& target,
  const WrapReference& reference, const ShrinkWrapOptions& options,
  const Execution& execution = {});

} // namespace evolving

#endif
