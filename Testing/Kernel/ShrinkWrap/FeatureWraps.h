// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Shrink-wrapping with PreserveFeatures.
 */

#ifndef EVOLVING_FEATURE_WRAPS_H
#define EVOLVING_FEATURE_WRAPS_H

#include "Shapes/Polyhedra.h"
#include "ShrinkWrap/Shortcomings.h"
#include "ShrinkWrap/WrapRuns.h"

#include <string>
#include <vector>

namespace evolving::wraps
{

/// A finished surface, and what there is to say of it.
struct Wrapped
{
  Wrapped(const SurfaceMesh& target, const ShrinkWrapOptions& options)
  {
    const ShrinkWrapProblem problem = prepareShrinkWrap(target, options);
    this->surface = run(problem);
    this->report = examineWrap(this->surface, problem);
    this->sentences = shortcomings(this->report, problem.edgeLength);
  }
  SurfaceMesh surface;
  SurfaceReport report;
  std::vector<std::string> sentences;
};

inline ShrinkWrapOptions withFeatures(double edgeLength)
{
  ShrinkWrapOptions options = quick(edgeLength, 48);
  options.preserveFeatures = FeaturePreservation::On;
  return options;
}

inline SurfaceMesh brick()
{
  return shapes::box(Vec3(0, 0, 0), Vec3(1, 2, 3));
}

} // namespace evolving::wraps

#endif
