// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The thesis's test problem (section 6.1): a unit sphere shrinks by its mean curvature for the time
 * 0.06, with r(t) = sqrt(1 - 4 t); computed by the kernel and by the thesis's scheme.
 */

#ifndef BENCHMARK_SHRINKING_SPHERE_H
#define BENCHMARK_SHRINKING_SPHERE_H

#include "ThesisScheme.h"
#include "Timing.h"

#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace benchmark
{

/// Steps of a quarter the length come with edges of half the length.
struct SphereSchedule
{
  double tau = 0.01;
  int steps = 6;
};

/// @param refinements of the coarsest sphere
SphereSchedule sphereSchedule(int refinements);

struct SphereRun
{
  /// (6.1) as its tables were computed: sqrt(sum_k tau sum_i (|F_i^k| - r)^2 mu_i^(k-1)). The
  /// printed formula has one square too many.
  double error = 0.0;
  Seconds time; ///< of the steps, without the start and the error
  long long coordinateIterations = 0;
  long long potentialIterations = 0;
};

/// By SurfaceFlow. Its iterations are not told apart: all count as those of the coordinates.
SphereRun shrinkByKernel(const evolving::SurfaceMesh& start, const SphereSchedule& schedule,
  double omega, double tolerance, int threads);

/// By ThesisScheme; omega = 0: without tangential velocity.
SphereRun shrinkByThesis(const evolving::SurfaceMesh& start, const SphereSchedule& schedule,
  const TangentialForm& form, double omega, const ThesisTolerances& tolerances);

} // namespace benchmark

#endif
