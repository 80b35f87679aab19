// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/SurfaceProjector.h"

#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

using namespace evolving;

TEST(SurfaceProjector, DoesNotJumpToTheOtherSideOfAWall)
{
  const SurfaceMesh plate = subdividedBox(4, Vec3(1.0, 1.0, 0.01));
  const SurfaceProjector projector(plate);
  const Vec3 fallback(9, 9, 9);
  const Vec3 belowMiddle(0.1, 0.2, -0.003);
  EXPECT_EQ(projector.project(belowMiddle, Vec3::UnitZ(), fallback), fallback);
  EXPECT_LT(
    (projector.project(belowMiddle, -Vec3::UnitZ(), fallback) - Vec3(0.1, 0.2, -0.01)).norm(),
    1e-14);
}
