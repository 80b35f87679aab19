// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/CurvatureLife.h"

#include "Mesh/Angles.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace evolving;

TEST(CurvatureLife, OfASphereIsAQuarterOfItsRadiusSquared)
{
  EXPECT_NEAR(longestLife(4.0 * Pi), 0.25, 1e-12);
  EXPECT_NEAR(expectedLife(4.0 * Pi, 4.0 / 3.0 * Pi, 8.0 * Pi), 0.25, 1e-12);
  for (const double radius : { 1e-3, 1.0, 1e3 })
  {
    const double half = 0.125 * radius * radius;
    const Vec3 far = 10.0 * radius * Vec3(1, 2, 3);
    EXPECT_NEAR(
      timeOfVisibleChange(shapes::transformed(icosphere(4), radius, far)), half, 0.005 * half);
    EXPECT_NEAR(timeOfVisibleChange(cubeSphere(16, radius)), half, 0.02 * half);
  }
}

TEST(CurvatureLife, OfAThinRingIsThatOfItsTube)
{
  // H integrates to 4 pi^2 R, the volume is 2 pi^2 R r^2: three quarters of r^2, of which half.
  const SurfaceMesh ring = shapes::torus(96, 24, 1.0, 0.1);
  EXPECT_NEAR(timeOfVisibleChange(ring), 0.375 * 0.01, 0.02 * 0.375 * 0.01);
}

TEST(CurvatureLife, OfSeveralPartsTheLongestCounts)
{
  const SurfaceMesh small = shapes::transformed(icosphere(2), 0.3, Vec3(3, 0, 0));
  const double large = timeOfVisibleChange(icosphere(3));
  EXPECT_NEAR(timeOfVisibleChange(shapes::merged(icosphere(3), small)), large, 1e-9);
}

TEST(CurvatureLife, OfASurfaceWithoutVolumeIsBoundedByItsArea)
{
  const SurfaceMesh sheet = shapes::sheet(6, true);
  EXPECT_NEAR(timeOfVisibleChange(sheet),
    0.25 * std::min(surfaceArea(sheet), 4.0 / Pi) + 0.5 * longestLife(surfaceArea(sheet)), 1e-12);
  EXPECT_GT(expectedLife(1.0, 1e-30, 1.0), 1e-4 * longestLife(1.0));
  EXPECT_EQ(expectedLife(1.0, 1.0, -1.0), longestLife(1.0)); // a sponge
  EXPECT_EQ(expectedLife(1.0, 0.0, 0.0), longestLife(1.0));
}
