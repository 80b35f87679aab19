// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Shrink-wrapping from a target to the finished surface, and what to expect of that.
 */

#ifndef EVOLVING_WRAP_RUNS_H
#define EVOLVING_WRAP_RUNS_H

#include "Evolution/SurfaceFlow.h"
#include "Mesh/TopologySummary.h"
#include "ShrinkWrap/ShrinkWrap.h"
#include "ShrinkWrap/SurfaceReport.h"
#include "ShrinkWrap/WrapResolution.h"
#include "ShrinkWrap/WrapTarget.h"

#include <gtest/gtest.h>

#include <cmath>

namespace evolving::wraps
{

/// A few hundred vertices on a model of extent 2, in a tenth of a second or two.
inline ShrinkWrapOptions quick(double edgeLength = 0.15, int samples = 40)
{
  ShrinkWrapOptions options;
  options.sampleDimensions = { samples, samples, samples };
  options.targetEdgeLength = edgeLength;
  return options;
}

/// A target as the first look sees it.
inline DescribedTarget describe(const SurfaceMesh& mesh, const ShrinkWrapOptions& options,
  const Execution& execution, const WrapTuning& tuning = {})
{
  return describeTarget(mesh, options, firstResolution(options), execution, tuning);
}

inline SurfaceMesh run(const ShrinkWrapProblem& problem, const Execution& execution = {})
{
  SurfaceFlow flow(problem.start, problem.field, problem.remesher, problem.flow, execution);
  while (!flow.isFinished())
  {
    flow.step();
  }
  EXPECT_EQ(flow.stopReason(), "");
  return flow.mesh();
}

inline SurfaceMesh wrap(const SurfaceMesh& target, const ShrinkWrapOptions& options = quick(),
  const Execution& execution = {})
{
  return run(prepareShrinkWrap(target, options, execution), execution);
}

/// The distance from a sphere about the origin.
inline Deviation fromSphere(double radius)
{
  return [radius](const Vec3& point) { return std::abs(point.norm() - radius); };
}

/// What every result must be.
inline void expectSound(
  const SurfaceMesh& surface, Index genus, Index components = 1, double leastAngle = 36.0)
{
  const SurfaceReport report = examine(surface, [](const Vec3&) { return 0.0; });
  EXPECT_TRUE(report.isClosed);
  EXPECT_TRUE(report.isManifold);
  EXPECT_EQ(report.selfIntersections, 0);
  EXPECT_EQ(report.genus, genus);
  EXPECT_EQ(summarizeTopology(surface).components, components);
  EXPECT_GT(report.minAngle, leastAngle);
  EXPECT_GT(signedVolume(surface), 0.0);
}

} // namespace evolving::wraps

#endif
