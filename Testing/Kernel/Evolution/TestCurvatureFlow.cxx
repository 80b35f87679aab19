// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceFlow.h"

#include "Evolution/EvolutionFields.h"
#include "Evolution/FlowRuns.h"
#include "Redistribution/SurfaceProjector.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/MixedPolygons.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace evolving;

namespace
{

void expectFallingArea(const SurfaceMesh& start, const FlowOptions& options)
{
  SurfaceFlow flow(start, nullptr, options);
  double area = flow.record().area;
  while (!flow.isFinished())
  {
    flow.step();
    EXPECT_LT(flow.record().area, area) << "step " << flow.record().iteration;
    area = flow.record().area;
  }
  EXPECT_EQ(flow.record().iteration, options.numberOfSteps);
}

/// The bumps of bumpySphere() on other meshes of the sphere.
SurfaceMesh bumpy(SurfaceMesh mesh)
{
  for (Vec3& p : mesh.points)
  {
    p *= 1.0 + 0.2 * std::sin(3.0 * p.x()) * std::cos(2.0 * p.y() + 1.0);
  }
  return mesh;
}

/// The smallest distance of vertices of one surface from the other, either way.
double gapBetween(const SurfaceMesh& a, const SurfaceMesh& b)
{
  double gap = std::numeric_limits<double>::infinity();
  const auto measure = [&gap](const SurfaceMesh& from, const SurfaceMesh& to)
  {
    const SurfaceProjector closest(to);
    for (const Vec3& p : from.points)
    {
      gap = std::min(gap, (closest.project(p, Vec3::Zero(), p) - p).norm());
    }
  };
  measure(a, b);
  measure(b, a);
  return gap;
}

} // namespace

TEST(CurvatureFlow, AreaFallsInEveryStep)
{
  const SurfaceMesh bulgingTube =
    shapes::tube(24, 12, 0.6, [](double z) { return 1.0 + 0.3 * std::sin(4.0 * z); });
  for (const SurfaceMesh& start :
    { shapes::bumpySphere(3), bumpy(cubeSphere(8)), bumpy(shapes::mixedSphere(3)),
      shapes::torus(24, 12, 1.0, 0.4), shapes::quadTorus(24, 12, 1.0, 0.4), bulgingTube })
  {
    expectFallingArea(start, flows::meanCurvatureFlow(0.002, 30));
    expectFallingArea(start, flows::meanCurvatureFlow(0.002, 30, 1.0));
    expectFallingArea(start, flows::meanCurvatureFlow(0.02, 3)); // an implicit step can be long
  }
}

TEST(CurvatureFlow, StaysBetweenTheSpheresAroundIt)
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

TEST(CurvatureFlow, TheGapBetweenNestedSurfacesNeverShrinks)
{
  const SurfaceMesh outer = shapes::bumpySphere(3);
  for (const SurfaceMesh& shape : { shapes::ellipsoid(3, Vec3(0.55, 0.45, 0.4)),
         shapes::transformed(bumpy(shapes::mixedSphere(3)), 0.45, Vec3::Zero()) })
  {
    const SurfaceMesh inner = shapes::transformed(shape, 1.0, Vec3(0.1, 0.05, 0.0));
    SurfaceFlow outside(outer, nullptr, flows::meanCurvatureFlow(0.002, 15));
    SurfaceFlow inside(inner, nullptr, flows::meanCurvatureFlow(0.002, 15));
    double gap = gapBetween(outer, inner);
    EXPECT_GT(gap, 0.05);
    while (!inside.isFinished())
    {
      outside.step();
      inside.step();
      const double now = gapBetween(outside.mesh(), inside.mesh());
      EXPECT_GT(now, gap) << "step " << inside.record().iteration;
      gap = now;
    }
    EXPECT_EQ(outside.stopReason() + inside.stopReason(), "");
    EXPECT_GT(signedVolume(outside.mesh()), signedVolume(inside.mesh()));
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
    shapes::merged(first, shapes::transformed(second, 1.0, Vec3(4, 0, 0))), nullptr, options);
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
