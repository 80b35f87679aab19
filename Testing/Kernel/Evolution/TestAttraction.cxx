// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceFlow.h"

#include "Checks/SurfaceMeasures.h"
#include "Evolution/EvolutionFields.h"
#include "Evolution/FlowRuns.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/SampledOnGrid.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;

TEST(Attraction, ReachesASphereFromOutsideAndFromInside)
{
  const auto field = shapes::sphereField(61, 1.6, 0.5);
  for (const double size : { 1.0, 0.2 })
  {
    SurfaceFlow flow(shapes::transformed(shapes::bumpySphere(3), size, Vec3(0.02, 0.0, 0.05)),
      field, flows::towardsSphere(150));
    flows::run(flow);
    EXPECT_EQ(flow.stopReason(), "");
    EXPECT_LT(checks::largestRadialError(flow.mesh(), 0.5), 0.01);
    EXPECT_LT(flow.record().maxDistance, 0.01);
    EXPECT_GT(flow.record().minAngle, 25.0);
    EXPECT_NEAR(flow.lengthUnit(), 0.5 * std::sqrt(3.0), 0.05);
  }
}

TEST(Attraction, DistanceFallsAsAdvectionSays)
{
  // Without curvature motion d' = -C d: after T the surface is e^(-C T) of its distance away.
  const auto field = shapes::sphereField(81, 1.2, 0.4);
  FlowOptions options = flows::towardsSphere(200);
  options.timeStep = 0.01;
  options.curvatureSpeed = 0.0;
  SurfaceFlow flow(icosphere(3), field, options);
  flows::run(flow);
  EXPECT_NEAR(flow.record().meanDistance, 0.6 * std::exp(-2.0), 2e-3);
}

TEST(Attraction, LongStepsAreDividedInside)
{
  const auto field = shapes::sphereField(61, 1.6, 0.5);
  FlowOptions options = flows::towardsSphere(4);
  options.timeStep = 2.5;
  options.advectionSpeed = 4.0; // tau C = 10
  options.redistribution.volume = 1e4;
  options.redistribution.angle = 3.0;
  SurfaceFlow flow(shapes::bumpySphere(2), field, options);
  flows::run(flow);
  EXPECT_EQ(flow.stopReason(), "");
  EXPECT_EQ(flow.record().iteration, 4);
  EXPECT_NEAR(flow.record().time, 10.0, 1e-12);
  EXPECT_LT(checks::largestRadialError(flow.mesh(), 0.5), 0.02);
}

TEST(Attraction, TheEdgeOfABallInAnImageAttractsASurface)
{
  const auto ball = shapes::image(shapes::cubicGrid(61, 1.5),
    [](const Vec3& p) { return 1.0 / (1.0 + std::exp((p.norm() - 0.6) / 0.05)); });
  FlowOptions options;
  options.relativeUnits = false;
  options.fieldMode = FieldMode::Image;
  options.edgeSharpness = 2.0;
  options.curvatureSpeed = 0.05;
  options.advectionSpeed = 0.05;
  options.timeStep = 0.05;
  options.numberOfSteps = 150;
  const auto radiusAtTheEnd = [&](double start)
  {
    SurfaceFlow flow(icosphere(2, start), ball, options);
    flows::run(flow);
    EXPECT_EQ(flow.stopReason(), "");
    EXPECT_LT(checks::largestRadialError(flow.mesh(), flow.mesh().points[0].norm()), 0.02);
    return flow.mesh().points[0].norm();
  };
  // -2 b e / r - a de/dr = 0 at r = 0.5913, just inside the edge at 0.6.
  EXPECT_NEAR(radiusAtTheEnd(1.0), 0.5913, 0.015);
  options.curvatureSpeed = 0.0005;
  EXPECT_NEAR(radiusAtTheEnd(0.45), 0.6, 0.015); // from inside as well
  options.advectionSpeed = 0.0;
  EXPECT_LT(radiusAtTheEnd(0.45), 0.45);
}
