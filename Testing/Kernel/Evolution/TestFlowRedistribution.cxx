// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceFlow.h"

#include "Evolution/EvolutionFields.h"
#include "Evolution/EvolutionShapes.h"
#include "Evolution/FlowRuns.h"

#include <gtest/gtest.h>

using namespace evolving;

TEST(FlowRedistribution, VolumeRedistributionEvensOutCoVolumes)
{
  SurfaceMesh start = icosphere(3);
  for (Vec3& p : start.points)
  {
    p = (p + Vec3(0, 0, 0.5)).normalized(); // crowded at the top
  }
  const auto field = shapes::sphereField(41, 1.6, 1.0);
  FlowOptions options = flows::towardsSphere(100);
  SurfaceFlow with(start, field, options);
  const double before = shapes::relativeSpread(with.arrays().coVolume);
  flows::run(with);
  EXPECT_GT(before, 0.4);
  EXPECT_LT(shapes::relativeSpread(with.arrays().coVolume), 0.05);
  options.redistribution.volume = 0.0;
  SurfaceFlow without(start, field, options);
  flows::run(without);
  EXPECT_GT(shapes::relativeSpread(without.arrays().coVolume), 0.8 * before);
}
