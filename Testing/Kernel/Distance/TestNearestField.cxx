// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/NearestField.h"

#include "DistanceShapes.h"

#include <gtest/gtest.h>

using namespace evolving;
using namespace evolving::test;

TEST(TriedTriangles, RememberTheLastEight)
{
  TriedTriangles tried;
  for (Index triangle = 0; triangle < 8; ++triangle)
  {
    EXPECT_TRUE(tried.insert(triangle));
    EXPECT_FALSE(tried.insert(triangle));
  }
  EXPECT_FALSE(tried.insert(0));
  EXPECT_TRUE(tried.insert(8));
  EXPECT_TRUE(tried.insert(0));
}

TEST(NearestField, TakesCloserTrianglesOnly)
{
  const SurfaceMesh mesh = sphere(2);
  const AABBTree tree(mesh);
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 12, 12, 12 }, 0.3);
  NearestField<float> field(tree, grid);
  const auto point = field.point(2, 3, 4);
  const Vec3 place = grid.point(2, 3, 4);
  Nearest sample;
  double best = std::numeric_limits<double>::infinity();
  for (Index triangle = 0; triangle < tree.triangleCount(); ++triangle)
  {
    field.tryTriangle(sample, triangle, point);
    const double squared = closestPointOnTriangle(place, tree.triangle(triangle)).squaredDistance;
    best = std::min(best, std::sqrt(squared) / grid.spacing.x());
    EXPECT_NEAR(sample.distance, best, 1e-4);
  }
}

TEST(NearestField, SkipsNeighboursThatCannotBeCloser)
{
  const SurfaceMesh mesh = sphere(2);
  const AABBTree tree(mesh);
  NearestField<double> field(tree, gridAround(boundingBox(mesh), { 12, 12, 12 }, 0.3));
  Nearest sample{ 2.0F, 0 };
  TriedTriangles tried;
  field.tryNeighbour(sample, { 3.5F, 1 }, field.point(0, 0, 0), 1.0F, tried);
  field.tryNeighbour(sample, Nearest(), field.point(0, 0, 0), 1.0F, tried);
  EXPECT_TRUE(tried.insert(1));
  EXPECT_EQ(sample.triangle, 0);
}
