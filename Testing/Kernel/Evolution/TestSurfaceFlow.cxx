// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceFlow.h"

#include "Errors.h"
#include "Evolution/EvolutionFields.h"
#include "Evolution/FlowRuns.h"
#include "Shapes/Spheres.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace evolving;

TEST(SurfaceFlow, EverythingIsAvailableForTheStart)
{
  const SurfaceMesh start = shapes::bumpySphere(2);
  FlowOptions options = flows::towardsSphere(3);
  const SurfaceFlow flow(start, shapes::sphereField(31, 1.6, 0.5), options);
  const StateArrays& arrays = flow.arrays();
  EXPECT_EQ(flow.record().iteration, 0);
  EXPECT_EQ(flow.record().time, 0.0);
  EXPECT_NEAR(flow.record().area, surfaceArea(start), 1e-12);
  EXPECT_NEAR(flow.record().volume, signedVolume(start), 1e-12);
  EXPECT_GT(flow.record().minAngle, 10.0);
  EXPECT_GT(flow.record().meanDistance, 0.3);
  EXPECT_TRUE(flow.mesh().points == start.points);
  for (const std::size_t size :
    { arrays.distance.size(), arrays.distanceGradient.size(), arrays.normal.size(),
      arrays.meanCurvature.size(), arrays.coVolume.size(), arrays.normalVelocity.size(),
      arrays.tangentialVelocity.size(), arrays.redistributionPotential.size() })
  {
    EXPECT_EQ(size, start.points.size());
  }
}

TEST(SurfaceFlow, ResumesFromAState)
{
  const auto field = shapes::sphereField(31, 1.6, 0.5);
  SurfaceFlow flow(shapes::bumpySphere(2), field, flows::towardsSphere(10));
  FlowState middle;
  while (!flow.isFinished())
  {
    flow.step();
    middle = flow.record().iteration == 4 ? flow.state() : middle;
  }
  SurfaceFlow again(shapes::bumpySphere(2), field, flows::towardsSphere(10));
  again.resume(middle);
  EXPECT_EQ(again.record().iteration, 4);
  flows::run(again);
  EXPECT_EQ(again.record().iteration, 10);
  for (std::size_t i = 0; i < middle.points.size(); ++i)
  {
    EXPECT_LT((again.mesh().points[i] - flow.mesh().points[i]).norm(), 1e-8);
  }
}

TEST(SurfaceFlow, HasTheSameBitsForAnyNumberOfThreads)
{
  const auto field = shapes::sphereField(31, 1.6, 0.5);
  FlowOptions options = flows::towardsSphere(2);
  options.redistribution.angle = 1.0;
  options.redistribution.length = 1.0;
  options.redistribution.curvatureControl = CurvatureControl::CubeRoot;
  const SurfaceMesh start = shapes::bumpySphere(5); // 10242 vertices
  SurfaceFlow serial(start, field, options);
  flows::run(serial);
  for (const int threads : { 1, 2, 8 })
  {
    SurfaceFlow flow(start, field, options, threadedExecution(threads, 5));
    flows::run(flow);
    EXPECT_TRUE(flow.mesh().points == serial.mesh().points) << threads << " threads";
    EXPECT_EQ(flow.arrays().redistributionPotential, serial.arrays().redistributionPotential);
    EXPECT_EQ(flow.record().area, serial.record().area);
    EXPECT_EQ(flow.record().solverIterations, serial.record().solverIterations);
  }
}

TEST(SurfaceFlow, ReportsProgressAndStopsOnRequest)
{
  std::vector<double> fractions;
  bool stop = false;
  const Execution execution(
    nullptr, [&](double fraction) { fractions.push_back(fraction); }, [&] { return stop; });
  SurfaceFlow flow(
    shapes::bumpySphere(3), nullptr, flows::meanCurvatureFlow(0.002, 10, 1.0), execution);
  for (int k = 0; k < 5; ++k)
  {
    flow.step();
  }
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_GT(fractions.back(), 0.4);
  EXPECT_LE(fractions.back(), 0.5);
  const std::vector<Vec3> before = flow.mesh().points;
  stop = true;
  EXPECT_THROW(flow.step(), Cancelled);
  EXPECT_TRUE(flow.mesh().points == before);
  EXPECT_EQ(flow.record().iteration, 5);
  stop = false;
  flows::run(flow);
  EXPECT_EQ(flow.record().iteration, 10);
}

TEST(SurfaceFlow, UnusedPointsStay)
{
  SurfaceMesh start = shapes::bumpySphere(2);
  start.addPoint(Vec3(0.1, 0.2, 0.3));
  SurfaceFlow flow(start, nullptr, flows::meanCurvatureFlow(0.002, 5, 1.0));
  flows::run(flow);
  EXPECT_EQ(flow.record().iteration, 5);
  EXPECT_EQ(flow.mesh().points.back(), Vec3(0.1, 0.2, 0.3));
}
