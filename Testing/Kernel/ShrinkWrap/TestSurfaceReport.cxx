// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/SurfaceReport.h"

#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <utility>

namespace
{

using namespace evolving;

TEST(SurfaceReport, OfASphereInsideAnother)
{
  const SurfaceReport report = examine(icosphere(3, 0.9), icosphere(5), 0.0);
  EXPECT_TRUE(report.isClosed);
  EXPECT_TRUE(report.isManifold);
  EXPECT_EQ(report.selfIntersections, 0);
  EXPECT_EQ(report.genus, 0);
  EXPECT_GT(report.minAngle, 50.0);
  EXPECT_NEAR(report.maxDistance, 0.1, 0.002);
}

TEST(SurfaceReport, MeasuresFromTheLevel)
{
  EXPECT_LT(examine(icosphere(3, 1.25), icosphere(5), 0.25).maxDistance, 0.002);
}

TEST(SurfaceReport, FindsAHoleAndAFlippedFace)
{
  SurfaceMesh open = icosphere(2);
  open.cornerVertices.resize(open.cornerVertices.size() - 3);
  open.faceOffsets.pop_back();
  const SurfaceReport ofOpen = examine(open, icosphere(2), 0.0);
  EXPECT_FALSE(ofOpen.isClosed);
  EXPECT_EQ(ofOpen.genus, -1);
  SurfaceMesh flipped = icosphere(2);
  std::swap(flipped.cornerVertices[0], flipped.cornerVertices[1]);
  EXPECT_FALSE(examine(flipped, icosphere(2), 0.0).isManifold);
}

TEST(SurfaceReport, CountsIntersections)
{
  SurfaceMesh dented = icosphere(3);
  // A vertex pulled through the far side.
  dented.points[20] *= -1.2;
  EXPECT_GT(examine(dented, icosphere(3), 0.0).selfIntersections, 0);
}

TEST(SurfaceReport, TakesPoints)
{
  SurfaceMesh points;
  points.points = icosphere(4).points;
  EXPECT_LT(examine(icosphere(4), points, 0.0).maxDistance, 1e-12);
}

} // namespace
