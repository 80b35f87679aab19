// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * New elements for a surface on its way to a target, and good ones when it is there.
 */

#ifndef EVOLVING_WRAP_REMESHER_H
#define EVOLVING_WRAP_REMESHER_H

#include "Evolution/Remesher.h"
#include "FeatureCapture/FeatureCoverage.h"
#include "Remeshing/IntersectionFreeStages.h"
#include "ShrinkWrap/ShrinkWrapOptions.h"
#include "ShrinkWrap/WrapReference.h"
#include "ShrinkWrap/WrapTarget.h"

#include <memory>

namespace evolving
{

/**
 * Remeshes by size, coarser far from the target, and keeps the surface free of self-intersections:
 * where a step made it run through itself, vertices go back. At the end, finishWrap().
 */
class WrapRemesher : public Remesher
{
public:
  WrapRemesher(std::shared_ptr<const WrapTarget> target,
    std::shared_ptr<const WrapReference> reference, const ShrinkWrapOptions& options);

  std::optional<SurfaceMesh> remesh(
    const RemeshingInput& input, const Execution& execution) override;

  /// A surface without self-intersections with elements of the right size.
  /// @throws InputError as requireFewVertices(). @throws Cancelled
  SurfaceMesh withRightSizes(const SurfaceMesh& surface, const std::vector<double>& distance,
    const Execution& execution) const;

  /// Of the finished surface.
  const FeatureCoverage& creases() const { return this->Creases; }
  const StageRuns& adaptation() const { return this->Adaptation; }

private:
  std::shared_ptr<const WrapTarget> Target;
  std::shared_ptr<const WrapReference> Reference;
  ShrinkWrapOptions Options;
  FeatureCoverage Creases;
  StageRuns Adaptation;
};

} // namespace evolving

#endif
