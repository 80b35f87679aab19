// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceFlow.h"

#include "Evolution/EvolutionFields.h"
#include "Evolution/EvolutionShapes.h"
#include "Evolution/FlowRuns.h"

#include <gtest/gtest.h>

using namespace evolving;

TEST(CurvatureFlow, AreaFallsInEveryStepOfMeanCurvatureFlow)
{
  for (const SurfaceMesh& start :
    { shapes::bumpySphere(3), cubeSphere(8), shapes::torusGrid(24, 12, 1.0, 0.4, true) })
  {
    SurfaceFlow flow(start, nullptr, flows::meanCurvatureFlow(0.002, 30, 1.0));
    double area = flow.record().area;
    while (!flow.isFinished())
    {
      flow.step();
      EXPECT_LT(flow.record().area, area);
      area = flow.record().area;
    }
    EXPECT_EQ(flow.record().iteration, 30);
  }
}

TEST(CurvatureFlow, NestedSurfacesStayNested)
{
  // The comparison principle: an ellipsoid between two spheres.
  SurfaceFlow flow(
    shapes::ellipsoid(3, Vec3(1.0, 0.8, 0.7)), nullptr, flows::meanCurvatureFlow(0.002, 50));
  while (!flow.isFinished())
  {
    flow.step();
    const double t = flow.record().time;
    for (const Vec3& p : flow.mesh().points)
    {
      EXPECT_LT(p.norm(), std::sqrt(1.0 - 4.0 * t) + 5e-3);
      EXPECT_GT(p.norm(), std::sqrt(0.49 - 4.0 * t) - 5e-3);
    }
  }
}

TEST(CurvatureFlow, AnEllipsoidGetsRounder)
{
  SurfaceFlow flow(
    shapes::ellipsoid(3, Vec3(1.3, 1.0, 0.8)), nullptr, flows::meanCurvatureFlow(0.002, 60, 1.0));
  const auto ratio = [&]()
  {
    const Vec3 sides = boundingBox(flow.mesh()).diagonal();
    return sides.maxCoeff() / sides.minCoeff();
  };
  const double before = ratio();
  flows::run(flow);
  EXPECT_LT(ratio() - 1.0, 0.8 * (before - 1.0));
}

TEST(CurvatureFlow, ComponentsEvolveAsIfAlone)
{
  const SurfaceMesh first = shapes::bumpySphere(2);
  const SurfaceMesh second = shapes::ellipsoid(2, Vec3(0.5, 0.7, 0.6));
  const FlowOptions options = flows::meanCurvatureFlow(0.002, 15, 2.0);
  SurfaceFlow alone(first, nullptr, options);
  SurfaceFlow both(
    shapes::together(first, shapes::transformed(second, 1.0, Vec3(4, 0, 0))), nullptr, options);
  flows::run(alone);
  flows::run(both);
  for (std::size_t i = 0; i < first.points.size(); ++i)
  {
    EXPECT_LT((alone.mesh().points[i] - both.mesh().points[i]).norm(), 1e-8);
  }
}

TEST(CurvatureFlow, SmoothingRemovesRoughnessAfterTheEvolution)
{
  SurfaceMesh start = icosphere(3, 0.5);
  for (std::size_t i = 0; i < start.points.size(); ++i)
  {
    start.points[i] *= 1.0 + (i % 2 == 0 ? 0.02 : -0.02);
  }
  const auto field = shapes::sphereField(41, 1.0, 0.5);
  FlowOptions options = flows::towardsSphere(0);
  options.smoothingSteps = 5;
  options.smoothingSpeed = 0.05;
  options.smoothingDecay = 0.5;
  SurfaceFlow flow(start, field, options);
  EXPECT_EQ(flow.totalSteps(), 5);
  double area = flow.record().area;
  std::vector<double> losses;
  while (!flow.isFinished())
  {
    flow.step();
    losses.push_back(area - flow.record().area);
    area = flow.record().area;
  }
  ASSERT_EQ(losses.size(), 5u);
  EXPECT_GT(losses[0], 2.0 * losses[4]);
  EXPECT_GT(flow.record().meanDistance, 0.0);
}
