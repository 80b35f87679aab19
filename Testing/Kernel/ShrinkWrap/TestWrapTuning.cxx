// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapTuning.h"

#include "ShrinkWrap/PointSurface.h"
#include "ShrinkWrap/WrapRuns.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

namespace evolving
{

namespace
{

SurfaceMesh wrapWith(const WrapTuning& tuning)
{
  return wraps::run(prepareShrinkWrap(icosphere(3), wraps::quick(0.3, 24), {}, tuning));
}

TEST(WrapTuning, LengthsAreThoseOfTheTarget)
{
  WrapTuning tuning;
  tuning.target.startPerEdge = 0.7;
  tuning.target.wallPerEdge = 0.2;
  tuning.finish.shortening = 0.9;
  const WrapTarget target = wraps::describe(icosphere(3), wraps::quick(0.3), {}, tuning).target;
  EXPECT_NEAR(target.startLevel, 0.7 * 0.3, 1e-12);
  EXPECT_NEAR(target.wall, 0.2 * 0.3, 1e-12);
  EXPECT_NEAR(target.elementSize(), 0.9 * 0.3, 1e-12);
}

TEST(WrapTuning, RatesAreThoseOfTheFlow)
{
  ShrinkWrapOptions options = wraps::quick(0.3, 24);
  options.start = WrapStart::Icosphere;
  WrapTuning tuning;
  tuning.flow.sphereBalance = 0.35;
  tuning.flow.longestAdvection = 0.4;
  tuning.flow.stallSteps = 7;
  const FlowOptions flow = prepareShrinkWrap(icosphere(3), options, {}, tuning).flow;
  EXPECT_EQ(flow.advectionBalance, 0.35);
  EXPECT_EQ(flow.longestAdvection, 0.4);
  EXPECT_EQ(flow.stallSteps, 7);
}

TEST(WrapTuning, TheFinishFollowsIt)
{
  const SurfaceMesh usual = wrapWith({});
  WrapTuning tuning;
  EXPECT_EQ(wrapWith(tuning).points, usual.points);
  tuning.finish.shortening = 0.8;
  EXPECT_GT(wrapWith(tuning).vertexCount(), 1.2 * usual.vertexCount());
  tuning = {};
  tuning.finish.uniformPasses = 0;
  EXPECT_NE(wrapWith(tuning).points, usual.points);
}

TEST(WrapTuning, SurfacesAmidstPointsFollowIt)
{
  SurfaceMesh points;
  points.points = icosphere(3).points;
  PointTuning coarse;
  coarse.elementPerSpacing = 2.4; // twice as large: a quarter of the vertices
  const SurfaceMesh usual = surfaceAmidst(points, wraps::quick(0.0, 32));
  const SurfaceMesh few = surfaceAmidst(points, wraps::quick(0.0, 32), {}, coarse);
  EXPECT_LT(few.vertexCount(), 0.4 * usual.vertexCount());
}

} // namespace

} // namespace evolving
