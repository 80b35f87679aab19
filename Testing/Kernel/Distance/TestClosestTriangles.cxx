// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/ClosestTriangles.h"

#include "Shapes/Tubes.h"
#include "ThreadedExecution.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <array>

using namespace evolving;
using namespace evolving::shapes;

TEST(ClosestTriangles, AreThoseOfSingleQueries)
{
  const SurfaceMesh mesh = torus(20, 10, 1.0, 0.3);
  const AABBTree tree(mesh);
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 14, 13, 7 }, 0.1);
  const std::vector<Index> triangles = queryClosestTriangles(tree, grid);
  forEachSample(grid, Execution(),
    [&](GridIndex sample, const Vec3& point)
    { EXPECT_EQ(triangles[static_cast<std::size_t>(sample)], tree.closest(point).triangle); });
  EXPECT_EQ(queryClosestTriangles(tree, grid, threadedExecution(8, 3)), triangles);
}

TEST(ClosestTriangles, OnTheBoundaryAreThoseOfTheWholeGrid)
{
  const SurfaceMesh mesh = torus(20, 10, 1.0, 0.3);
  const AABBTree tree(mesh);
  for (const std::array<int, 3>& size : { std::array<int, 3>{ 9, 7, 8 }, { 9, 7, 1 }, { 1, 1, 5 } })
  {
    const DistanceGrid grid = gridAround(boundingBox(mesh), size, 0.1);
    const std::vector<Index> all = queryClosestTriangles(tree, grid);
    const std::vector<Index> boundary = queryBoundaryTriangles(tree, grid);
    for (int k = 0; k < size[2]; ++k)
    {
      for (int j = 0; j < size[1]; ++j)
      {
        for (int i = 0; i < size[0]; ++i)
        {
          const bool isInside =
            i > 0 && i + 1 < size[0] && j > 0 && j + 1 < size[1] && k > 0 && k + 1 < size[2];
          const auto s = static_cast<std::size_t>(grid.index(i, j, k));
          EXPECT_EQ(boundary[s], isInside ? NoIndex : all[s]);
        }
      }
    }
  }
}

TEST(ClosestTriangles, TheGridContainsAllTrianglesOrNot)
{
  const Box surface(Vec3(0, 0, 0), Vec3(1, 1, 1));
  EXPECT_TRUE(containsAll(gridOver(Box(Vec3(0, 0, 0), Vec3(1, 1, 1)), { 5, 5, 5 }), surface));
  EXPECT_FALSE(containsAll(gridOver(Box(Vec3(0, 0, 0), Vec3(1, 1, 0.9)), { 5, 5, 5 }), surface));
  EXPECT_FALSE(containsAll(gridOver(Box(Vec3(0, 0, 0), Vec3(1, 1, 1)), { 5, 5, 1 }), surface));
}
