// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/StallTest.h"

#include "Evolution/EvolutionFields.h"
#include "Evolution/FlowRuns.h"
#include "Shapes/SampledOnGrid.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace evolving;

namespace
{

/// From a sphere onto a torus of radii 0.6 and 0.25: a membrane stays in its hole.
SurfaceFlow ontoATorus(const FlowOptions& options)
{
  const auto torus = shapes::image(shapes::cubicGrid(33, 1.6),
    [](const Vec3& p) { return std::hypot(p.head<2>().norm() - 0.6, p.z()) - 0.25; });
  return SurfaceFlow(icosphere(3, 1.1), torus, options);
}

FlowOptions stallingFlow(int stallSteps)
{
  FlowOptions options = flows::towardsSphere(120);
  options.timeStep = 0.2;
  options.stallSteps = stallSteps;
  return options;
}

} // namespace

TEST(StallTest, CountsTheStepsSinceTheLastGain)
{
  StallTest test;
  EXPECT_FALSE(test.hasStalled(0, 1.0, 3));
  EXPECT_FALSE(test.hasStalled(1, 0.98, 3)); // a gain of 2 %
  EXPECT_FALSE(test.hasStalled(2, 0.975, 3));
  EXPECT_FALSE(test.hasStalled(3, 0.972, 3));
  EXPECT_TRUE(test.hasStalled(4, 0.971, 3)); // 0.9 % in three steps
}

TEST(StallTest, SmallGainsAddUp)
{
  StallTest test;
  double distance = 1.0;
  for (int k = 0; k < 100; ++k)
  {
    EXPECT_FALSE(test.hasStalled(k, distance, 4)) << k;
    distance *= 0.996; // more than 1 % in three steps
  }
}

TEST(StallTest, MovingAwayAndBackIsNoGain)
{
  StallTest test;
  EXPECT_FALSE(test.hasStalled(0, 1.0, 2));
  EXPECT_FALSE(test.hasStalled(1, 2.0, 2));
  EXPECT_TRUE(test.hasStalled(2, 1.0, 2));
}

TEST(StallTest, ZeroIsAsNearAsCanBe)
{
  StallTest test;
  EXPECT_FALSE(test.hasStalled(0, 1.0, 1));
  EXPECT_FALSE(test.hasStalled(1, 0.0, 1));
  EXPECT_TRUE(test.hasStalled(2, 0.0, 1));
}

TEST(StallTest, EndsARunAsConverged)
{
  SurfaceFlow flow = ontoATorus(stallingFlow(5));
  std::vector<double> farthest = { flow.record().maxDistance };
  while (!flow.isFinished())
  {
    flow.step();
    farthest.push_back(flow.record().maxDistance);
  }
  EXPECT_TRUE(flow.hasConverged());
  EXPECT_EQ(flow.stopReason(), "");
  EXPECT_LT(flow.record().iteration, 60);
  EXPECT_NEAR(farthest.back(), 0.35, 0.02);
  // Five steps without a gain, and none of five before.
  const std::size_t end = farthest.size() - 1;
  EXPECT_GE(farthest[end], 0.99 * farthest[end - 5]);
  for (std::size_t k = 5; k < end; ++k)
  {
    EXPECT_LT(farthest[k], 0.99 * farthest[k - 5]) << k;
  }
}

TEST(StallTest, IsOffByDefault)
{
  SurfaceFlow flow = ontoATorus(stallingFlow(0));
  flows::run(flow);
  EXPECT_FALSE(flow.hasConverged());
  EXPECT_EQ(flow.record().iteration, 120);
}

TEST(StallTest, NeedsDistances)
{
  FlowOptions options = flows::meanCurvatureFlow(0.001, 20);
  options.stallSteps = 1;
  SurfaceFlow free(icosphere(1), nullptr, options);
  flows::run(free);
  EXPECT_EQ(free.record().iteration, 20);
  options.fieldMode = FieldMode::Image;
  options.edgeSharpness = 1.0;
  const auto ball = shapes::image(shapes::cubicGrid(33, 1.6),
    [](const Vec3& p) { return 1.0 / (1.0 + std::exp((p.norm() - 0.6) / 0.1)); });
  SurfaceFlow image(icosphere(2, 0.9), ball, options);
  flows::run(image);
  EXPECT_EQ(image.record().iteration, 20);
}

TEST(StallTest, SmoothingFollowsAStall)
{
  FlowOptions options = stallingFlow(5);
  options.smoothingSteps = 3;
  options.smoothingSpeed = 1e-4;
  SurfaceFlow flow = ontoATorus(options);
  double atTheStall = 0.0;
  while (!flow.isFinished())
  {
    flow.step();
    if (flow.hasConverged() && flow.record().iteration < 120)
    {
      EXPECT_TRUE(atTheStall == 0.0 || atTheStall == flow.record().area);
      atTheStall = flow.record().area;
    }
  }
  EXPECT_EQ(flow.record().iteration, 123);
  EXPECT_LT(flow.record().area, atTheStall);
}

TEST(StallTest, IsPartOfAState)
{
  SurfaceFlow whole = ontoATorus(stallingFlow(5));
  FlowState middle;
  while (!whole.isFinished())
  {
    middle = whole.state();
    whole.step();
  }
  SurfaceFlow resumed = ontoATorus(stallingFlow(5));
  resumed.resume(middle); // a step before the stall
  EXPECT_FALSE(resumed.isFinished());
  flows::run(resumed);
  EXPECT_EQ(resumed.record().iteration, whole.record().iteration);
  resumed.resume(whole.state());
  EXPECT_TRUE(resumed.isFinished());
}
