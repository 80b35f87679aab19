// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "VolumeFlows/RelaxationTime.h"

#include "Evolution/AutomaticTimeStep.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "VolumeFlows/VolumeFlowRuns.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;

TEST(RelaxationTime, LeavesAThousandthOnABall)
{
  const SurfaceMesh ball = shapes::sphere(4, 2.0);
  EXPECT_NEAR(std::exp(-4.0 / 4.0 * relaxationTimeOfCurvatureFlow(ball)), 1e-3, 3e-5);
  EXPECT_NEAR(std::exp(-24.0 / 16.0 * relaxationTimeOfDiffusion(ball)), 1e-3, 6e-5);
}

TEST(RelaxationTime, GrowsAsTheFlowsDo)
{
  const SurfaceMesh small = shapes::bumpySphere(2);
  const SurfaceMesh large = shapes::transformed(small, 3.0, Vec3(1.0, 2.0, 3.0));
  const double curvature = relaxationTimeOfCurvatureFlow(small);
  EXPECT_NEAR(relaxationTimeOfCurvatureFlow(large), 9.0 * curvature, 1e-9 * curvature);
  const double diffusion = relaxationTimeOfDiffusion(small);
  EXPECT_NEAR(relaxationTimeOfDiffusion(large), 81.0 * diffusion, 1e-9 * diffusion);
  const SurfaceMesh both = shapes::merged(small, large);
  EXPECT_EQ(relaxationTimeOfDiffusion(both), relaxationTimeOfDiffusion(large));
}

TEST(RelaxationTime, MakesTheAutomaticStep)
{
  const SurfaceMesh start = shapes::ellipsoid(2, Vec3(3.0, 2.0, 1.0));
  FlowOptions options = flows::volumePreserving(100);
  options.curvatureSpeed = 0.5;
  const double time = relaxationTimeOfCurvatureFlow(start) / 0.5;
  EXPECT_NEAR(automaticTimeStep(start, nullptr, options, 1.0), time / 100.0, 1e-12);
  options.flow = Flow::SurfaceDiffusion;
  EXPECT_NEAR(automaticTimeStep(start, nullptr, options, 1.0),
    relaxationTimeOfDiffusion(start) / 50.0, 1e-12);
}
