// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/SurfaceBand.h"

#include "Distance/AABBTree.h"
#include "DistanceShapes.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

using namespace evolving;
using namespace evolving::test;

namespace
{

struct Band
{
  Band(const SurfaceMesh& mesh, const Vec3& spacing, double reach, const Execution& execution = {})
    : tree(mesh)
  {
    grid.dimensions = { 22, 21, 23 };
    grid.spacing = spacing;
    grid.origin = -0.5 * spacing.cwiseProduct(Vec3(21, 20, 22));
    for (const Triangle& triangle : tree.triangles())
    {
      triangles.emplace_back(triangle);
      boxes.push_back(triangle.box());
    }
    nearest.resize(std::size_t(22 * 21 * 23));
    drawSurfaceBand(triangles, boxes, grid, reach, nearest, execution);
  }

  AABBTree tree;
  UnitGrid grid;
  std::vector<MeasuredTriangle<float>> triangles;
  std::vector<Box> boxes;
  std::vector<Nearest> nearest;
};

void expectExactWithin(const Band& band, double reach)
{
  int within = 0;
  for (int k = 0; k < band.grid.dimensions[2]; ++k)
  {
    for (int j = 0; j < band.grid.dimensions[1]; ++j)
    {
      for (int i = 0; i < band.grid.dimensions[0]; ++i)
      {
        const Nearest& sample = band.nearest[static_cast<std::size_t>(band.grid.index(i, j, k))];
        const double exact =
          std::sqrt(band.tree.closest(band.grid.point(i, j, k)).at.squaredDistance);
        if (exact <= reach)
        {
          ++within;
          ASSERT_NEAR(sample.distance, exact, 1e-4) << i << " " << j << " " << k;
        }
        ASSERT_GE(sample.distance, exact - 1e-4);
      }
    }
  }
  EXPECT_GT(within, 100);
}

} // namespace

TEST(SurfaceBand, IsExactWithinItsReach)
{
  const SurfaceMesh ball = sphere(3, 6.3, Vec3(0.3, -0.2, 0.1));
  expectExactWithin(Band(ball, Vec3(1, 1, 1), 1.0), 1.0);
  expectExactWithin(Band(ball, Vec3(1, 1, 1), 2.5), 2.5);
  expectExactWithin(Band(ball, Vec3(0.6, 1, 0.8), 1.0), 1.0);
}

TEST(SurfaceBand, IsExactForSlantedAndDegenerateTriangles)
{
  SurfaceMesh soup = randomSoup(60, 0.8, 7);
  for (Vec3& point : soup.points)
  {
    point *= 9.0;
  }
  expectExactWithin(Band(soup, Vec3(1, 1, 1), 1.0), 1.0);
  // Triangles far larger than the grid, and parallel to its axes.
  const SurfaceMesh large =
    merged(triangleMesh(Vec3(-90, -80, 1.5), Vec3(90, -80, 1.5), Vec3(0, 150, 1.5)),
      triangleMesh(Vec3(-90, -80, -60), Vec3(90, -80, 20), Vec3(0, 150, 30)));
  expectExactWithin(Band(large, Vec3(1, 1, 1), 1.0), 1.0);
}

TEST(SurfaceBand, IsTheSameForAnyNumberOfThreads)
{
  const SurfaceMesh ball = sphere(3, 6.3);
  const Band serial(ball, Vec3(1, 1, 1), 1.0);
  for (const int threads : { 2, 8 })
  {
    const Band band(ball, Vec3(1, 1, 1), 1.0, threadedExecution(threads, 3));
    for (std::size_t s = 0; s < serial.nearest.size(); ++s)
    {
      ASSERT_EQ(band.nearest[s].triangle, serial.nearest[s].triangle);
    }
  }
}
