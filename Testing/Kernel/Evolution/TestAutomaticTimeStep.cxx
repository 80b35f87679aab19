// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/AutomaticTimeStep.h"

#include "Evolution/EvolutionFields.h"
#include "Evolution/FlowRuns.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/SampledOnGrid.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;

namespace
{

FlowOptions automatic(int steps)
{
  FlowOptions options = flows::meanCurvatureFlow(0.0, steps);
  options.curvatureSpeed = 0.5;
  return options;
}

} // namespace

TEST(AutomaticTimeStep, TakesASphereHalfOfItsWayToAPoint)
{
  for (const int steps : { 10, 100 })
  {
    const SurfaceFlow flow(icosphere(4), nullptr, automatic(steps));
    EXPECT_NEAR(flow.timeStep(), 0.25 / steps, 0.005 * 0.25 / steps); // life 1/2 at this speed
  }
}

TEST(AutomaticTimeStep, GrowsWithTheSquareOfLengthsOrIsRelative)
{
  const SurfaceMesh start = shapes::bumpySphere(3);
  const SurfaceMesh large = shapes::transformed(start, 8.0, Vec3::Zero());
  FlowOptions options = automatic(20);
  const double step = SurfaceFlow(start, nullptr, options).timeStep();
  EXPECT_NEAR(SurfaceFlow(large, nullptr, options).timeStep(), 64.0 * step, 1e-9 * step);
  options.relativeUnits = true;
  EXPECT_NEAR(SurfaceFlow(start, nullptr, options).timeStep(),
    SurfaceFlow(large, nullptr, options).timeStep(), 1e-12 * step);
}

TEST(AutomaticTimeStep, LeavesAThousandthOfADistanceAlsoWhereItIsHeldBack)
{
  FlowOptions options = automatic(50);
  options.curvatureSpeed = 0.0;
  options.advectionSpeed = 3.0;
  SurfaceFlow flow(icosphere(2, 1.0), shapes::sphereField(61, 1.6, 0.5), options);
  EXPECT_NEAR(std::exp(-0.5 * 3.0 * 50 * flow.timeStep()), 1e-3, 1e-12);
  flows::run(flow);
  // The explicit steps come a little nearer.
  EXPECT_LT(flow.record().meanDistance, 1e-3);
}

TEST(AutomaticTimeStep, IsThereWhateverIsOff)
{
  const auto field = shapes::sphereField(21, 1.6, 0.5);
  for (const double curvature : { 0.0, 1.0, 1e300 })
  {
    for (const double advection : { 0.0, 1.0, 1e300 })
    {
      for (const int steps : { 0, 3 })
      {
        FlowOptions options = automatic(steps);
        options.curvatureSpeed = curvature;
        options.advectionSpeed = advection;
        options.normalSpeed = -advection;
        for (const FieldMode mode : { FieldMode::DistanceField, FieldMode::Image })
        {
          options.fieldMode = mode;
          EXPECT_GT(automaticTimeStep(icosphere(1), field.get(), options, 1.0), 0.0);
          EXPECT_GT(automaticTimeStep(icosphere(1), nullptr, options, 1.0), 0.0);
          EXPECT_LE(automaticTimeStep(icosphere(1), field.get(), options, 1.0), LongestTimeStep);
        }
      }
    }
  }
}
