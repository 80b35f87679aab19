// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Where on the start the vertices of a flow's new elements come from.

#include "Evolution/StartTrace.h"

#include "Evolution/EvolutionFields.h"
#include "Evolution/FlowRuns.h"
#include "Evolution/Remeshers.h"
#include "Evolution/StateSeries.h"
#include "Evolution/SurfaceRemesher.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <vector>

using namespace evolving;

namespace
{

constexpr int Steps = 20;

/// A sphere that shrinks to .45 of its radius and has new elements in most steps.
StateSeries remeshedSphere(bool tracesStart, std::size_t memoryLimit)
{
  FlowOptions options = flows::meanCurvatureFlow(0.01, Steps, 1.0);
  options.tracesStart = tracesStart;
  const auto start = std::make_shared<const SurfaceMesh>(icosphere(3));
  const auto remesher = std::make_shared<SurfaceRemesher>(*start, SurfaceRemeshingOptions());
  return StateSeries([=](const Execution& host)
    { return SurfaceFlow(start, nullptr, remesher, options, host); },
    publishedIterations(Steps, 0, 1), memoryLimit, Execution());
}

constexpr std::size_t NoLimit = std::numeric_limits<std::size_t>::max();

void expectDirections(const FlowState& state)
{
  ASSERT_TRUE(state.startPoints);
  ASSERT_EQ(state.startPoints->size(), state.points.size());
  for (std::size_t i = 0; i < state.points.size(); ++i)
  {
    const Vec3& from = (*state.startPoints)[i];
    ASSERT_GT(from.norm(), 0.99); // on the start's triangles, whose middles are at .994
    ASSERT_LE(from.norm(), 1.0 + 1e-12);
    ASSERT_LT((from.normalized() - state.points[i].normalized()).norm(), 0.01);
  }
}

TEST(StartTrace, PointsOfASphereComeFromTheDirectionTheyLieIn)
{
  StateSeries series = remeshedSphere(true, NoLimit);
  const auto state = series.state(Steps, {});
  ASSERT_LT(state->points.size(), 300u); // of 642
  expectDirections(*state);
}

TEST(StartTrace, SoDoThoseOfStatesThatAreComputedAgain)
{
  StateSeries series = remeshedSphere(true, 0);
  for (const std::size_t step : { 13U, 9U, 20U, 11U })
  {
    SCOPED_TRACE(step);
    expectDirections(*series.state(step, {}));
  }
}

TEST(StartTrace, TheStartsElementsNeedNone)
{
  StateSeries series = remeshedSphere(true, NoLimit);
  EXPECT_FALSE(series.state(0, {})->startPoints);
  StateSeries untraced = remeshedSphere(false, NoLimit);
  EXPECT_FALSE(untraced.state(Steps, {})->startPoints);
  EXPECT_EQ(untraced.state(Steps, {})->points, series.state(Steps, {})->points);
}

TEST(StartTrace, VerticesThatStayComeFromWhereTheyCameFrom)
{
  const SurfaceMesh start = icosphere(2);
  const StartTrace trace(start);
  SurfaceMesh small = start;
  for (Vec3& point : small.points)
  {
    point *= 0.5;
  }
  const std::vector<Vec3> same = trace.carryOver(small, start.points, small);
  const std::vector<Vec3> finer = trace.carryOver(small, start.points, remeshers::inFour(small));
  for (std::size_t i = 0; i < start.points.size(); ++i)
  {
    EXPECT_LT((same[i] - start.points[i]).norm(), 1e-12);
    EXPECT_LT((finer[i] - start.points[i]).norm(), 1e-12);
  }
}

TEST(StartTrace, PolygonsAreStartsToo)
{
  const SurfaceMesh start = cubeSphere(8);
  const StartTrace trace(start);
  const std::vector<Vec3> from = trace.carryOver(start, start.points, icosphere(2));
  for (const Vec3& point : from)
  {
    EXPECT_NEAR(point.norm(), 1.0, 0.03);
  }
}

} // namespace
