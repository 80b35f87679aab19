// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceFlow.h"

#include "Evolution/EvolutionShapes.h"
#include "Evolution/FlowRuns.h"

#include <gtest/gtest.h>

using namespace evolving;

TEST(BoundaryModes, AFreeBoundaryShrinksAndASlidingOneKeepsItsShape)
{
  const SurfaceMesh start = shapes::shakenSheet(8, true, 0.3, 12);
  FlowOptions options = flows::meanCurvatureFlow(0.001, 10, 1.0);
  options.boundaryMode = BoundaryMode::Free;
  SurfaceFlow free(start, nullptr, options);
  flows::run(free);
  EXPECT_LT(free.record().area, 0.99);
  options.boundaryMode = BoundaryMode::SlideAlong;
  options.timeStep = 0.1;
  SurfaceFlow sliding(start, nullptr, options);
  flows::run(sliding);
  EXPECT_EQ(sliding.stopReason(), "");
  EXPECT_NEAR(sliding.record().area, 1.0, 1e-12);
  EXPECT_GT((sliding.mesh().points[3] - start.points[3]).norm(), 1e-3);
  EXPECT_EQ(sliding.mesh().points[0], start.points[0]);
}
