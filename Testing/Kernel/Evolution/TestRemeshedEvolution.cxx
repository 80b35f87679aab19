// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Flows with SurfaceRemesher beside the same flows without.

#include "Checks/SurfaceMeasures.h"
#include "Evolution/EvolutionFields.h"
#include "Evolution/FlowRuns.h"
#include "Evolution/Remeshers.h"
#include "Evolution/SurfaceRemesher.h"
#include "Mesh/MeshQuality.h"
#include "Mesh/SelfIntersections.h"
#include "Remeshing/EditingChecks.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/SampledOnGrid.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

using namespace evolving;

namespace
{

constexpr ElementSizing Both[] = { ElementSizing::Uniform, ElementSizing::CurvatureAdaptive };

std::shared_ptr<Remesher> remesherOf(
  const SurfaceMesh& start, ElementSizing sizing, double edgeLength = 0.0)
{
  return std::make_shared<SurfaceRemesher>(start, SurfaceRemeshingOptions{ sizing, edgeLength });
}

SurfaceFlow finished(const SurfaceMesh& start, const std::shared_ptr<Remesher>& remesher,
  const FlowOptions& options, const std::shared_ptr<const ScalarImage>& field = nullptr)
{
  SurfaceFlow flow = remeshers::flowOf(start, field, remesher, options);
  flows::run(flow);
  return flow;
}

/// Two balls that a neck joins.
SurfaceMesh dumbbell()
{
  SurfaceMesh mesh = icosphere(4);
  for (Vec3& p : mesh.points)
  {
    const double radius = 0.35 + 0.85 * std::pow(std::abs(p.z()), 1.5);
    p = Vec3(radius * p.x(), radius * p.y(), 2.0 * p.z());
  }
  return mesh;
}

/// Negative in three balls with blended seams: no convex body.
double threeBalls(const Vec3& p)
{
  constexpr double Blend = 12.0;
  double sum = 0.0;
  for (const Vec3& centre : { Vec3(0.7, 0.0, 0.0), Vec3(-0.5, 0.6, 0.0), Vec3(-0.5, -0.6, 0.2) })
  {
    sum += std::exp(-Blend * ((p - centre).norm() - 0.62));
  }
  return -std::log(sum) / Blend;
}

} // namespace

TEST(RemeshedEvolution, ASphereShrinksAtLeastAsWell)
{
  const SurfaceMesh start = shapes::unevenSphere(3);
  for (const int steps : { 20, 50, 80 })
  {
    const FlowOptions options = flows::meanCurvatureFlow(0.002, steps);
    const double radius = std::sqrt(1.0 - 4.0 * 0.002 * steps);
    const SurfaceMesh without = finished(start, nullptr, options).mesh();
    for (const ElementSizing sizing : Both)
    {
      const SurfaceMesh with = finished(start, remesherOf(start, sizing), options).mesh();
      EXPECT_LT(
        checks::largestRadialError(with, radius), checks::largestRadialError(without, radius));
      EXPECT_LT(std::abs(checks::meanRadius(with) - radius), 0.012 * radius);
      EXPECT_GT(smallestAngle(with), smallestAngle(without) + 10.0);
      EXPECT_NEAR(meanEdgeLength(with), meanEdgeLength(start), 0.1 * meanEdgeLength(start));
    }
  }
}

TEST(RemeshedEvolution, ASphereVanishesAtItsTime)
{
  const SurfaceMesh start = icosphere(3);
  for (const ElementSizing sizing : Both)
  {
    const SurfaceFlow flow =
      finished(start, remesherOf(start, sizing), flows::meanCurvatureFlow(0.005, 100));
    EXPECT_EQ(flow.stopReason(), "");
    ASSERT_TRUE(flow.extinctionTime());
    EXPECT_NEAR(*flow.extinctionTime(), 0.25, 0.015);
    EXPECT_GT(smallestAngle(flow.mesh()), 35.0);
    EXPECT_EQ(editing::kindOf(flow.mesh()), (editing::Kind{ 2, 0, 1 }));
  }
}

TEST(RemeshedEvolution, TheLargerOfTwoSpheresGoesOnAlone)
{
  const SurfaceMesh start =
    shapes::merged(icosphere(3), shapes::transformed(icosphere(2), 0.3, Vec3(3.0, 0.0, 0.0)));
  for (const ElementSizing sizing : Both)
  {
    const SurfaceFlow flow =
      finished(start, remesherOf(start, sizing), flows::meanCurvatureFlow(0.002, 60));
    EXPECT_EQ(flow.stopReason(), "");
    EXPECT_EQ(editing::kindOf(flow.mesh()), (editing::Kind{ 2, 0, 1 }));
    EXPECT_LT(checks::largestRadialError(flow.mesh(), std::sqrt(1.0 - 4.0 * 0.12)), 0.006);
  }
}

TEST(RemeshedEvolution, ATorusKeepsItsHole)
{
  const SurfaceMesh start = shapes::torus(60, 12, 1.0, 0.4);
  const FlowOptions options = flows::meanCurvatureFlow(0.002, 20);
  const SurfaceFlow without = finished(start, nullptr, options);
  for (const ElementSizing sizing : Both)
  {
    const SurfaceFlow with = finished(start, remesherOf(start, sizing, 0.15), options);
    EXPECT_EQ(editing::kindOf(with.mesh()), (editing::Kind{ 0, 0, 1 }));
    EXPECT_GT(smallestAngle(with.mesh()), 35.0);
    EXPECT_LT(smallestAngle(without.mesh()), 25.0);
    EXPECT_NEAR(with.record().volume, without.record().volume, 0.02 * without.record().volume);
  }
}

TEST(RemeshedEvolution, ANeckThinsWithGoodElements)
{
  const SurfaceMesh start = dumbbell();
  const FlowOptions options = flows::meanCurvatureFlow(0.002, 30);
  const SurfaceFlow without = finished(start, nullptr, options);
  EXPECT_LT(smallestAngle(without.mesh()), 6.0);
  for (const ElementSizing sizing : Both)
  {
    const SurfaceFlow with = finished(start, remesherOf(start, sizing), options);
    EXPECT_GT(smallestAngle(with.mesh()), 33.0);
    EXPECT_TRUE(selfIntersections(with.mesh()).empty());
    EXPECT_NEAR(with.record().volume, without.record().volume, 0.03 * without.record().volume);
    // When the neck has closed the flow may end, with a sentence.
    const SurfaceFlow longer =
      finished(start, remesherOf(start, sizing), flows::meanCurvatureFlow(0.002, 100));
    EXPECT_EQ(editing::kindOf(longer.mesh()), (editing::Kind{ 2, 0, 1 }));
  }
}

TEST(RemeshedEvolution, AFixedBoundaryStays)
{
  const SurfaceMesh start = shapes::halfSphere(10);
  const FlowOptions options = flows::meanCurvatureFlow(0.001, 40);
  const SurfaceFlow without = finished(start, nullptr, options);
  for (const ElementSizing sizing : Both)
  {
    const SurfaceFlow with = finished(start, remesherOf(start, sizing), options);
    int onRim = 0;
    for (const Vec3& p : with.mesh().points)
    {
      onRim += std::abs(p.z()) < 1e-12 && std::abs(p.norm() - 1.0) < 1e-12 ? 1 : 0;
    }
    EXPECT_EQ(onRim, 60);
    EXPECT_GT(smallestAngle(with.mesh()), 36.0);
    EXPECT_NEAR(with.record().area, without.record().area, 0.003 * without.record().area);
  }
}

TEST(RemeshedEvolution, GoodElementsOnAConcaveTarget)
{
  const auto field = shapes::image(shapes::cubicGrid(61, 1.9), threeBalls);
  const SurfaceMesh start = icosphere(4, 1.6);
  FlowOptions options;
  options.timeStep = 0.06;
  options.numberOfSteps = 75;
  options.curvatureSpeed = 0.1;
  options.curvatureRange = 0.1;
  options.advectionBalance = 0.3;
  const SurfaceFlow without = finished(start, nullptr, options, field);
  EXPECT_LT(smallestAngle(without.mesh()), 15.0);
  for (const ElementSizing sizing : Both)
  {
    const SurfaceFlow with = finished(start, remesherOf(start, sizing, 0.08), options, field);
    EXPECT_EQ(with.stopReason(), "");
    EXPECT_GT(smallestAngle(with.mesh()), 35.0);
    EXPECT_LT(with.mesh().vertexCount(), 1.1 * start.vertexCount());
    EXPECT_LE(with.record().meanDistance, 1.05 * without.record().meanDistance);
    EXPECT_LE(with.record().maxDistance, 1.05 * without.record().maxDistance);
    EXPECT_TRUE(selfIntersections(with.mesh()).empty());
  }
}
