// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/UnsignedDistance.h"

#include "Distance/ClosestTriangles.h"
#include "Errors.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;
using namespace evolving::shapes;

TEST(UnsignedDistance, ToTrianglesIsThatOfTheClosestPoint)
{
  const SurfaceMesh mesh = torus(30, 16, 1.0, 0.35);
  const AABBTree tree(mesh);
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 14, 13, 8 }, 0.1);
  const UnsignedDistance field = distanceToTriangles(mesh, grid, queryClosestTriangles(tree, grid));
  forEachSample(grid, Execution(),
    [&](GridIndex sample, const Vec3& point)
    {
      const auto s = static_cast<std::size_t>(sample);
      EXPECT_NEAR(field.distance[s], std::sqrt(tree.closest(point).at.squaredDistance), 1e-6);
      EXPECT_EQ(field.lowerBound()[s], field.distance[s]);
    });
}

TEST(UnsignedDistance, BySweepingIsExactInTheCellsOfTheSurface)
{
  const SurfaceMesh mesh = torus(30, 16, 1.0, 0.35);
  const AABBTree tree(mesh);
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 24, 24, 12 }, 0.1);
  const UnsignedDistance field = distanceBySweeping(tree, grid, 8);
  int leaves = 0;
  forEachSample(grid, Execution(),
    [&](GridIndex sample, const Vec3& point)
    {
      const auto s = static_cast<std::size_t>(sample);
      const double exact = std::sqrt(tree.closest(point).at.squaredDistance);
      EXPECT_LE(field.clearance[s], exact + 1e-4 * grid.spacing.x());
      EXPECT_NEAR(field.distance[s], exact, 1.5 * grid.spacing.x());
      if (field.triangle[s] != NoIndex)
      {
        ++leaves;
        EXPECT_NEAR(field.distance[s], exact, 1e-6);
        EXPECT_LE(exact, 0.5 * std::sqrt(3.0) * grid.spacing.x() + 1e-9);
      }
    });
  EXPECT_GT(leaves, 200);
}

TEST(UnsignedDistance, BySweepingNeedsCubes)
{
  const AABBTree tree(sphere(1));
  EXPECT_THROW(
    distanceBySweeping(tree, gridOver(Box(Vec3(-2, -2, -2), Vec3(2, 2, 2)), { 5, 9, 5 }), 8),
    InputError);
}
