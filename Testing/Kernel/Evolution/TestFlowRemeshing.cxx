// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Flows whose surfaces get new elements on the way.

#include "Evolution/SurfaceFlow.h"

#include "Checks/SurfaceMeasures.h"
#include "Evolution/EvolutionFields.h"
#include "Evolution/FlowRuns.h"
#include "Evolution/Remeshers.h"
#include "Evolution/StateMeasures.h"
#include "Mesh/MeshQuality.h"
#include "Mesh/MeshTopology.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

using namespace evolving;

namespace
{

double farthest(const std::vector<double>& distances)
{
  double largest = 0.0;
  for (const double d : distances)
  {
    largest = std::max(largest, std::abs(d));
  }
  return largest;
}

} // namespace

TEST(FlowRemeshing, TakesPlaceAtIntervalsAndAtTheEnd)
{
  FlowOptions options = flows::meanCurvatureFlow(0.001, 7);
  options.smoothingSteps = 4;
  options.smoothingSpeed = 0.1;
  options.remeshingInterval = 3;
  int calls = 0;
  const auto counter = remeshers::byRule(
    [&calls](const SurfaceMesh& /*mesh*/, const std::vector<double>& distance)
    {
      EXPECT_TRUE(distance.empty());
      ++calls;
      return std::optional<SurfaceMesh>();
    });
  SurfaceFlow flow = remeshers::flowOf(icosphere(1), nullptr, counter, options);
  std::vector<int> iterations;
  for (int before = 0; !flow.isFinished(); before = calls)
  {
    flow.step();
    if (calls > before)
    {
      iterations.push_back(flow.record().iteration);
    }
  }
  EXPECT_EQ(iterations, (std::vector<int>{ 3, 6, 9, 11 }));
}

TEST(FlowRemeshing, AStateIsThatOfTheNewElements)
{
  const auto field = shapes::sphereField(41, 1.6, 0.5);
  int calls = 0;
  const auto maker = remeshers::byRule(
    [&](const SurfaceMesh& mesh, const std::vector<double>& distance)
    {
      ++calls;
      EXPECT_EQ(distance.size(), mesh.points.size());
      for (std::size_t i = 0; i < distance.size(); ++i)
      {
        EXPECT_EQ(distance[i], field->at(mesh.points[i]).value);
      }
      return std::make_optional(icosphere(2, 0.8));
    });
  SurfaceFlow flow = remeshers::flowOf(icosphere(1, 0.9), field, maker, flows::towardsSphere(1));
  flow.step();
  EXPECT_EQ(calls, 1);
  EXPECT_TRUE(flow.mesh() == icosphere(2, 0.8));
  EXPECT_TRUE(remeshers::fit(flow.arrays(), 162));
  const FlowRecord& record = flow.record();
  EXPECT_NEAR(record.area, surfaceArea(flow.mesh()), 1e-12);
  EXPECT_NEAR(record.volume, signedVolume(flow.mesh()), 1e-12);
  EXPECT_EQ(record.minAngle, smallestAngle(flow.mesh(), Execution()));
  EXPECT_EQ(record.maxDistance, farthest(flow.arrays().distance));
  EXPECT_NEAR(record.maxDistance, 0.3, 0.005);
  EXPECT_EQ(record.iteration, 1);
}

TEST(FlowRemeshing, ConvergenceIsThatOfTheStep)
{
  // The vertices' numbers change in every step, so that they seem to jump.
  FlowOptions options = flows::towardsSphere(2000);
  options.timeStep = 0.2;
  options.convergenceTolerance = 1e-4;
  const auto field = shapes::sphereField(61, 1.6, 0.5);
  SurfaceFlow plain(shapes::bumpySphere(2), field, options);
  SurfaceFlow flow =
    remeshers::flowOf(shapes::bumpySphere(2), field, remeshers::renumberer(), options);
  flows::run(plain);
  flows::run(flow);
  EXPECT_TRUE(flow.hasConverged());
  EXPECT_EQ(flow.record().iteration, plain.record().iteration);
  EXPECT_NEAR(flow.record().area, plain.record().area, 1e-6);
}

TEST(FlowRemeshing, TheStateThatConvergesIsCleanToo)
{
  FlowOptions options = flows::towardsSphere(2000);
  options.timeStep = 0.2;
  options.convergenceTolerance = 1e-4;
  options.remeshingInterval = 1999;
  SurfaceFlow flow = remeshers::flowOf(
    icosphere(2, 0.9), shapes::sphereField(61, 1.6, 0.5), remeshers::refiner(642), options);
  flows::run(flow);
  EXPECT_TRUE(flow.hasConverged());
  EXPECT_LT(flow.record().iteration, 500);
  EXPECT_EQ(flow.mesh().vertexCount(), 642);
  EXPECT_LT(checks::largestRadialError(flow.mesh(), 0.5), 0.01);
}

TEST(FlowRemeshing, VerticesSlideOnAlongTheNewBoundary)
{
  FlowOptions options = flows::meanCurvatureFlow(0.002, 20, 1.0);
  options.boundaryMode = BoundaryMode::SlideAlong;
  options.redistribution.length = 50.0;
  options.remeshingInterval = 10;
  const SurfaceMesh start = shapes::halfSphere(6);
  SurfaceFlow flow = remeshers::flowOf(start, nullptr, remeshers::refiner(200), options);
  while (flow.record().iteration < 10)
  {
    flow.step();
  }
  const SurfaceMesh remeshed = flow.mesh();
  EXPECT_EQ(remeshed.faceCount(), 4 * start.faceCount());
  flows::run(flow);
  EXPECT_EQ(flow.stopReason(), "");
  EXPECT_TRUE(haveEqualFaces(flow.mesh(), remeshed));
  const MeshTopology topology(remeshed);
  int onBoundary = 0;
  for (Index i = 0; i < remeshed.vertexCount(); ++i)
  {
    if (topology.isBoundary(i))
    {
      ++onBoundary;
      const Vec3& p = flow.mesh().points[static_cast<std::size_t>(i)];
      EXPECT_NEAR(p.z(), 0.0, 1e-12);
      EXPECT_LT((p - remeshed.points[static_cast<std::size_t>(i)]).norm(), 0.05);
      EXPECT_NEAR(p.norm(), 1.0, 0.004); // on the polygon of 72 edges
    }
  }
  EXPECT_EQ(onBoundary, 72);
}

TEST(FlowRemeshing, AComponentThatVanishesLeavesTheOthersAlone)
{
  // Each remeshing starts it anew, ever smaller; it has four fifths of all faces.
  const SurfaceMesh large = shapes::bumpySphere(2);
  const FlowOptions options = flows::meanCurvatureFlow(0.002, 60, 1.0);
  SurfaceFlow alone(large, nullptr, options);
  flows::run(alone);
  for (const double radius : { 0.1, 0.03, 1e-3, 1e-5 })
  {
    const SurfaceMesh small = shapes::transformed(icosphere(3), radius, Vec3(3, 0, 0));
    SurfaceFlow both =
      remeshers::flowOf(shapes::merged(large, small), nullptr, remeshers::renumberer(), options);
    flows::run(both);
    EXPECT_EQ(both.stopReason(), "") << radius;
    EXPECT_NEAR(both.record().area, alone.record().area, 1e-6 * alone.record().area) << radius;
  }
}

TEST(FlowRemeshing, ARemesherThatGivesNoSurfaceEndsTheRun)
{
  SurfaceMesh fin = icosphere(1);
  const Index tip = fin.addPoint(Vec3(1.2, 1.2, 1.2));
  fin.addFace({ fin.faceVertex(0, 0), fin.faceVertex(0, 1), tip });
  const SurfaceMesh outside = shapes::transformed(icosphere(1), 1.0, Vec3(5, 0, 0));
  for (const SurfaceMesh& bad : { SurfaceMesh(), fin, outside })
  {
    FlowOptions options = flows::meanCurvatureFlow(0.001, 6);
    options.remeshingInterval = 3;
    SurfaceFlow flow = remeshers::flowOf(icosphere(1), nullptr,
      remeshers::byRule(
        [&](const SurfaceMesh&, const std::vector<double>&) { return std::make_optional(bad); }),
      options);
    flows::run(flow);
    EXPECT_EQ(flow.stopReason().find("The evolution ended before step 3: "), 0u)
      << flow.stopReason();
    EXPECT_EQ(flow.record().iteration, 2);
    EXPECT_TRUE(haveEqualFaces(flow.mesh(), icosphere(1)));
    EXPECT_EQ(flow.arrays().coVolume.size(), 42u);
    EXPECT_NEAR(flow.record().area, surfaceArea(flow.mesh()), 1e-12);
  }
}
