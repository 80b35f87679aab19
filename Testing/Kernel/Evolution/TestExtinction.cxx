// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// A surface that shrinks to a point has come to its end, and the last state is a surface.

#include "Evolution/ExtinctionTest.h"
#include "Evolution/FlowCourse.h"
#include "Evolution/FlowRuns.h"
#include "Evolution/StateSeries.h"
#include "Mesh/MeshQuality.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>

using namespace evolving;

TEST(Extinction, OfASphereIsAtItsTime)
{
  for (const int level : { 2, 3, 4 })
  {
    for (const int steps : { 50, 300 })
    {
      const double timeStep = 0.25 / steps;
      const Course course =
        follow(icosphere(level), nullptr, flows::meanCurvatureFlow(timeStep, 2 * steps));
      EXPECT_EQ(course.stopReason, "");
      ASSERT_TRUE(course.extinctionTime);
      // Implicit steps are late, by some of them; and a coarse sphere is smaller than it.
      EXPECT_NEAR(*course.extinctionTime, 0.25, 4.0 * timeStep + (level == 2 ? 0.01 : 0.003));
      EXPECT_GT(*course.extinctionTime, course.record.time);
      EXPECT_LE(*course.extinctionTime, course.record.time + timeStep);
      EXPECT_GT(course.record.area, 10.0 * timeStep); // the sphere that lives for a step has 16 pi
      EXPECT_GT(course.record.minAngle, 30.0);
    }
  }
}

TEST(Extinction, OfAThinRingIsThatOfItsTube)
{
  // r^2 / 2, and a little earlier, for the ring shrinks, too.
  const SurfaceMesh ring = shapes::torus(96, 12, 1.0, 0.1);
  const Course course = follow(ring, nullptr, flows::meanCurvatureFlow(1e-4, 1000));
  EXPECT_EQ(course.stopReason, "");
  ASSERT_TRUE(course.extinctionTime);
  EXPECT_NEAR(*course.extinctionTime, 0.005, 0.0005);
}

TEST(Extinction, MayBeInTheFirstStep)
{
  SurfaceFlow flow(icosphere(2), nullptr, flows::meanCurvatureFlow(10.0, 5));
  EXPECT_TRUE(flow.isFinished());
  EXPECT_NEAR(flow.extinctionTime().value_or(0.0), 0.25, 0.01);
  flow.step();
  EXPECT_EQ(flow.record().iteration, 0);
}

TEST(Extinction, IsWhatAFailureMeansWhenNextToNothingIsLeft)
{
  const FlowOptions options = flows::meanCurvatureFlow(0.01, 20);
  FlowRecord record;
  record.area = 4.0;
  const StateArrays arrays;
  ExtinctionTest closed(icosphere(1), false, options);
  closed.begin(record, arrays);
  ExtinctionTest towardsTarget(icosphere(1), true, options);
  towardsTarget.begin(record, arrays);
  EXPECT_FALSE(closed.isNearlyGone(record));
  record.area = 0.0041;
  EXPECT_FALSE(closed.isNearlyGone(record));
  record.area = 0.0039;
  EXPECT_TRUE(closed.isNearlyGone(record));
  EXPECT_FALSE(towardsTarget.isNearlyGone(record));
}

TEST(Extinction, IsNoneAtTheEndOfARunOrWithABoundary)
{
  const double timeStep = 0.01;
  SurfaceFlow flow(icosphere(3), nullptr, flows::meanCurvatureFlow(timeStep, 20));
  flows::run(flow);
  EXPECT_FALSE(flow.extinctionTime());
  SurfaceFlow open(shapes::sheet(6, true), nullptr, flows::meanCurvatureFlow(10.0, 3));
  flows::run(open);
  EXPECT_FALSE(open.extinctionTime());
  EXPECT_EQ(open.record().iteration, 3);
}

TEST(Extinction, EndsTheIterationsOfASeries)
{
  const auto start = std::make_shared<const SurfaceMesh>(icosphere(2));
  StateSeries series([start](const Execution& host)
    { return SurfaceFlow(start, nullptr, nullptr, flows::meanCurvatureFlow(0.01, 100), host); },
    publishedIterations(100, 0, 4), std::size_t(1) << 30, Execution());
  ASSERT_TRUE(series.extinctionTime());
  const std::vector<int> iterations = series.iterations();
  EXPECT_EQ(iterations.back(), series.lastIteration());
  EXPECT_LT(iterations.back(), 30);
  for (std::size_t i = 0; i < iterations.size(); ++i)
  {
    EXPECT_EQ(series.state(i, Execution())->record.iteration, iterations[i]);
    EXPECT_TRUE(i + 1 == iterations.size() || iterations[i] == 4 * static_cast<int>(i));
  }
}
