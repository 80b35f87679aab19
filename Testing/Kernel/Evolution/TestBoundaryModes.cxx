// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceFlow.h"

#include "Evolution/FlowRuns.h"
#include "Mesh/Angles.h"
#include "Mesh/MeshTopology.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;

namespace
{

constexpr double FreeTimeStep = 0.05;

/**
 * One implicit step from the unit square with the natural boundary condition: both coordinates
 * satisfy g - tau g'' = s over 0 < s < 1, g' = 0 at the ends.
 */
double freeCoordinate(double s)
{
  const double range = std::sqrt(FreeTimeStep);
  return s - range * std::sinh((s - 0.5) / range) / std::cosh(0.5 / range);
}

/// The root mean square distance from that solution after one step.
double freeStepError(const SurfaceMesh& start)
{
  FlowOptions options = flows::meanCurvatureFlow(FreeTimeStep, 1);
  options.boundaryMode = BoundaryMode::Free;
  SurfaceFlow flow(start, nullptr, options);
  const std::vector<double> mu = flow.arrays().coVolume;
  flow.step();
  EXPECT_EQ(flow.stopReason(), "");
  double square = 0.0;
  Vec3 shiftOfCentre = Vec3::Zero();
  for (std::size_t i = 0; i < mu.size(); ++i)
  {
    const Vec3& p = start.points[i];
    const Vec3 exact(freeCoordinate(p.x()), freeCoordinate(p.y()), 0.0);
    square += mu[i] * (flow.mesh().points[i] - exact).squaredNorm();
    shiftOfCentre += mu[i] * (flow.mesh().points[i] - p);
  }
  EXPECT_LT(shiftOfCentre.norm(), 1e-12); // L has constants in its kernel
  return std::sqrt(square);
}

/// A square whose vertices crowd towards a corner, its sides straight.
SurfaceMesh crowdedSheet(Index n)
{
  SurfaceMesh mesh = shapes::sheet(n, false);
  for (Vec3& p : mesh.points)
  {
    p.x() = std::pow(p.x(), 1.4);
    p.y() = std::pow(p.y(), 1.4);
  }
  return mesh;
}

} // namespace

TEST(BoundaryModes, AFreeBoundarySatisfiesTheNaturalConditionWithSecondOrder)
{
  for (const bool triangles : { true, false })
  {
    double coarse = freeStepError(shapes::shakenSheet(8, triangles, 0.2, 3));
    EXPECT_LT(coarse, 0.02);
    for (const Index n : { 16, 32, 64 })
    {
      const double fine = freeStepError(shapes::shakenSheet(n, triangles, 0.2, 3));
      EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.15) << "from " << n / 2 << " to " << n;
      coarse = fine;
    }
  }
}

TEST(BoundaryModes, AFreeSurfaceLosesAreaInEveryStep)
{
  FlowOptions options = flows::meanCurvatureFlow(0.001, 20);
  options.boundaryMode = BoundaryMode::Free;
  SurfaceFlow flow(shapes::halfSphere(6), nullptr, options);
  double area = flow.record().area;
  while (!flow.isFinished())
  {
    flow.step();
    EXPECT_LT(flow.record().area, area);
    area = flow.record().area;
  }
  EXPECT_EQ(flow.record().iteration, 20);
}

TEST(BoundaryModes, SlidingMakesTheSidesOfASquareEven)
{
  constexpr Index n = 8;
  const SurfaceMesh start = crowdedSheet(n);
  FlowOptions options = flows::meanCurvatureFlow(0.1, 150);
  options.redistribution.length = 1.0;
  options.boundaryMode = BoundaryMode::SlideAlong;
  SurfaceFlow flow(start, nullptr, options);
  flows::run(flow);
  EXPECT_EQ(flow.stopReason(), "");
  const SurfaceMesh even = shapes::sheet(n, false);
  const MeshTopology topology(start);
  for (Index i = 0; i < start.vertexCount(); ++i)
  {
    const auto v = static_cast<std::size_t>(i);
    if (topology.isBoundary(i))
    {
      EXPECT_LT((flow.mesh().points[v] - even.points[v]).norm(), 1e-6) << "vertex " << i;
    }
  }
  for (const Index corner : { Index(0), n, n * (n + 1), n * (n + 2) })
  {
    const auto v = static_cast<std::size_t>(corner);
    EXPECT_EQ(flow.mesh().points[v], start.points[v]);
  }
  EXPECT_NEAR(flow.record().area, 1.0, 1e-13); // the sides are where they were
}

TEST(BoundaryModes, AHalfSphereRelaxesToTheDiscInItsBoundary)
{
  for (const BoundaryMode mode : { BoundaryMode::Fixed, BoundaryMode::SlideAlong })
  {
    const SurfaceMesh start = shapes::halfSphere(6);
    FlowOptions options = flows::meanCurvatureFlow(0.05, 60);
    options.redistribution.length = 1.0;
    options.boundaryMode = mode;
    SurfaceFlow flow(start, nullptr, options);
    flows::run(flow);
    EXPECT_EQ(flow.stopReason(), "");
    const double polygon = 18.0 * std::sin(Pi / 18.0); // of 36 corners
    EXPECT_NEAR(flow.record().area, polygon, 1e-9);
    for (const Vec3& p : flow.mesh().points)
    {
      EXPECT_NEAR(p.z(), 0.0, 1e-6);
    }
  }
}

TEST(BoundaryModes, OnlyASlidingBoundaryMovesAndOnlyAlongItself)
{
  const SurfaceMesh start = shapes::shakenSheet(8, true, 0.3, 12);
  FlowOptions options = flows::meanCurvatureFlow(0.1, 10, 1.0);
  options.boundaryMode = BoundaryMode::SlideAlong;
  SurfaceFlow sliding(start, nullptr, options);
  options.boundaryMode = BoundaryMode::Fixed;
  SurfaceFlow fixed(start, nullptr, options);
  flows::run(sliding);
  flows::run(fixed);
  for (std::size_t i = 0; i <= 8; ++i) // the side y = 0
  {
    EXPECT_EQ(fixed.mesh().points[i], start.points[i]);
    EXPECT_EQ(sliding.mesh().points[i].y(), 0.0);
  }
  EXPECT_GT((sliding.mesh().points[3] - start.points[3]).norm(), 1e-3);
  EXPECT_EQ(sliding.mesh().points[0], start.points[0]);
  EXPECT_NEAR(sliding.record().area, 1.0, 1e-12);
}
