// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// What a problem holds that is ready to run, as the allocator counts it.

#include "ShrinkWrap/ShrinkWrap.h"

#include "AllocatedBytes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

using namespace evolving;

TEST(ShrinkWrapMemory, AProblemHoldsOneGridAndItsReference)
{
  if (!allocatorCounts())
  {
    GTEST_SKIP() << "this allocator does not count";
  }
  ShrinkWrapOptions options;
  options.sampleDimensions = { 96, 96, 96 };
  options.targetEdgeLength = 0.2;
  const SurfaceMesh target = icosphere(3);
  const double before = bytesInUse();
  const ShrinkWrapProblem problem = prepareShrinkWrap(target, options);
  const double held = (bytesInUse() - before) / MiB;
  const double grid = static_cast<double>(problem.field->values().size()) * sizeof(float) / MiB;
  EXPECT_GT(grid, 3.0);
  EXPECT_LT(held, 1.5 * grid); // four grids are there while it is made
  // The start belongs to the states.
  const double counted = static_cast<double>(bytesOf(problem)) / MiB;
  EXPECT_NEAR(held, counted, 0.15 * counted);
}
