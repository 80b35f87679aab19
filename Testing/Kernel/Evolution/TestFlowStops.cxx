// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceFlow.h"

#include "Checks/SurfaceMeasures.h"
#include "Errors.h"
#include "Evolution/EvolutionFields.h"
#include "Evolution/FlowRuns.h"
#include "Mesh/MeshTopology.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace evolving;

TEST(FlowStops, EndsWhenNothingMovesAnyMore)
{
  const auto field = shapes::sphereField(61, 1.6, 0.5);
  FlowOptions options = flows::towardsSphere(2000);
  options.timeStep = 0.2;
  options.convergenceTolerance = 1e-4;
  SurfaceFlow flow(shapes::bumpySphere(2), field, options);
  flows::run(flow);
  EXPECT_TRUE(flow.hasConverged());
  EXPECT_EQ(flow.stopReason(), "");
  EXPECT_LT(flow.record().iteration, 500);
  // With smoothing steps the state waits for them.
  options.numberOfSteps = 200;
  options.smoothingSteps = 2;
  options.smoothingSpeed = 0.001;
  SurfaceFlow smoothed(shapes::bumpySphere(2), field, options);
  double areaWhenConverged = 0.0;
  while (!smoothed.isFinished())
  {
    smoothed.step();
    if (smoothed.hasConverged() && smoothed.record().iteration < 200)
    {
      EXPECT_TRUE(areaWhenConverged == 0.0 || areaWhenConverged == smoothed.record().area);
      areaWhenConverged = smoothed.record().area;
    }
  }
  EXPECT_EQ(smoothed.record().iteration, 202);
  EXPECT_LT(smoothed.record().area, areaWhenConverged);
}

TEST(FlowStops, EndsWhenTheSurfaceVanishes)
{
  SurfaceFlow flow(icosphere(2), nullptr, flows::meanCurvatureFlow(0.02, 100, 1.0));
  flows::run(flow);
  EXPECT_EQ(flow.stopReason(), "");
  EXPECT_TRUE(flow.extinctionTime());
  EXPECT_LT(flow.record().iteration, 30);
  EXPECT_GE(flow.record().iteration, 12); // extinction at t = 1/4
  for (const Vec3& p : flow.mesh().points)
  {
    EXPECT_TRUE(p.allFinite());
  }
  EXPECT_EQ(static_cast<Index>(flow.arrays().coVolume.size()), 162);
}

TEST(FlowStops, StopsAtTheGuardWithTheLastGoodState)
{
  // Without curvature motion nothing pulls points back that leave a sphere along its tangents.
  SurfaceMesh start = icosphere(2);
  for (Vec3& p : start.points)
  {
    p = (p + Vec3(0, 0, 0.4)).normalized();
  }
  FlowOptions options = flows::meanCurvatureFlow(0.1, 100, 5.0);
  options.curvatureSpeed = 0.0;
  options.surfaceGuard = 1.0;
  SurfaceFlow flow(start, nullptr, options);
  flows::run(flow);
  EXPECT_NE(flow.stopReason().find("bounding box"), std::string::npos) << flow.stopReason();
  EXPECT_LT(flow.record().iteration, 100);
  const Box box = boundingBox(start);
  for (const Vec3& p : flow.mesh().points)
  {
    EXPECT_LT(box.exteriorDistance(p), 1e-8);
  }
}

TEST(FlowStops, AnyParametersEndInAFiniteSurface)
{
  std::mt19937 random(2020);
  const auto logarithmic = [&](double low, double high)
  {
    std::uniform_real_distribution<double> exponent(std::log(low), std::log(high));
    return std::exp(exponent(random));
  };
  const auto field = shapes::sphereField(21, 1.6, 0.5);
  const std::vector<SurfaceMesh> starts = { shapes::bumpySphere(1), cubeSphere(3),
    shapes::shakenSheet(4, true, 0.4, 1), shapes::quadTorus(8, 6, 1.0, 0.4) };
  for (int trial = 0; trial < 60; ++trial)
  {
    FlowOptions options;
    options.timeStep = logarithmic(1e-6, 1e4);
    options.numberOfSteps = 5;
    options.curvatureSpeed = random() % 4 ? logarithmic(1e-8, 1e4) : 0.0;
    options.curvatureRange = logarithmic(1e-6, 1e4);
    options.advectionSpeed = random() % 4 ? logarithmic(1e-6, 1e6) : 0.0;
    options.advectionBalance = 0.5 * static_cast<double>(random() % 3);
    options.fieldMode = static_cast<FieldMode>(random() % 3);
    options.edgeSharpness = logarithmic(1e-3, 1e3); // the automatic one sees no edges here
    options.normalSpeed = random() % 2 ? logarithmic(1e-6, 1e4) : 0.0;
    options.unsignedField = random() % 2;
    options.redistribution.volume = random() % 2 ? logarithmic(1e-3, 1e6) : 0.0;
    options.redistribution.angle = random() % 2 ? logarithmic(1e-3, 1e6) : 0.0;
    options.redistribution.length = random() % 2 ? logarithmic(1e-3, 1e6) : 0.0;
    options.redistribution.angleWeighting = static_cast<AngleWeighting>(random() % 3);
    options.redistribution.curvatureControl = static_cast<CurvatureControl>(random() % 4);
    options.boundaryMode = static_cast<BoundaryMode>(random() % 3);
    options.smoothingSteps = static_cast<int>(random() % 3);
    options.smoothingSpeed = logarithmic(1e-6, 1e2);
    options.relativeUnits = random() % 2;
    SurfaceFlow flow(starts[random() % 4], random() % 4 ? field : nullptr, options);
    flows::run(flow);
    EXPECT_TRUE(!flow.stopReason().empty() || flow.extinctionTime() ||
      flow.record().iteration == flow.totalSteps());
    for (const Vec3& p : flow.mesh().points)
    {
      ASSERT_TRUE(p.allFinite()) << "trial " << trial;
    }
    for (const Vec3& v : flow.arrays().tangentialVelocity)
    {
      ASSERT_TRUE(v.allFinite()) << "trial " << trial;
    }
    ASSERT_TRUE(std::isfinite(flow.record().area + flow.record().volume + flow.record().minAngle));
  }
}

TEST(FlowStops, SurvivesDegenerateFaces)
{
  SurfaceMesh start = shapes::bumpySphere(2);
  const MeshTopology topology(start);
  // One vertex onto its neighbour, another onto the middle of an edge of its ring.
  start.points[50] = start.points[static_cast<std::size_t>(topology.ringVertices(50)[0])];
  const MeshTopology::Run ring = topology.ringVertices(90);
  start.points[90] = 0.5 *
    (start.points[static_cast<std::size_t>(ring[0])] +
      start.points[static_cast<std::size_t>(ring[1])]);
  SurfaceFlow flow(start, shapes::sphereField(31, 1.6, 0.5), flows::towardsSphere(60));
  flows::run(flow);
  EXPECT_EQ(flow.stopReason(), "");
  EXPECT_LT(checks::largestRadialError(flow.mesh(), 0.5), 0.05);
}

TEST(FlowStops, RefusesWhatItCannotUse)
{
  const auto make = [](SurfaceMesh mesh, const FlowOptions& options = FlowOptions())
  { SurfaceFlow flow(std::move(mesh), nullptr, options); };
  EXPECT_THROW(make(SurfaceMesh()), InputError);
  SurfaceMesh points;
  points.addPoint(Vec3::Zero());
  EXPECT_THROW(make(points), InputError);
  SurfaceMesh bad = icosphere(1);
  bad.points[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(make(bad), InputError);
  EXPECT_THROW(make(shapes::transformed(icosphere(1), 0.0, Vec3::Zero())), InputError);
  SurfaceMesh fin = icosphere(1);
  const Index tip = fin.addPoint(Vec3(2, 2, 2));
  fin.addFace({ fin.faceVertex(0, 0), fin.faceVertex(0, 1), tip });
  EXPECT_THROW(make(fin), InputError);
  FlowOptions options;
  options.timeStep = -1.0;
  EXPECT_THROW(make(icosphere(1), options), InputError);
}
