// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/ClosestPointSweep.h"

#include "Distance/ClosestTriangles.h"
#include "DistanceShapes.h"
#include "Errors.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <array>

using namespace evolving;
using namespace evolving::test;

namespace
{

struct SweepError
{
  double mean = 0.0;
  double largest = 0.0;
};

/// How much farther the swept triangles are than the closest ones, in cells.
SweepError sweepError(const SurfaceMesh& mesh, const DistanceGrid& grid)
{
  const AABBTree tree(mesh);
  const std::vector<Index> swept = sweepClosestTriangles(mesh, tree, grid);
  SweepError error;
  forEachSample(grid, Execution(),
    [&](GridIndex sample, const Vec3& point)
    {
      const Index triangle = swept[static_cast<std::size_t>(sample)];
      const double found =
        std::sqrt(closestPointOnTriangle(point, tree.triangle(triangle)).squaredDistance);
      const double exact = std::sqrt(tree.closest(point).at.squaredDistance);
      const double excess = (found - exact) / grid.spacing.maxCoeff();
      EXPECT_GE(excess, -1e-9);
      error.mean += excess / static_cast<double>(grid.sampleCount());
      error.largest = std::max(error.largest, excess);
    });
  return error;
}

} // namespace

TEST(ClosestPointSweep, IsNearlyExact)
{
  const std::array<SurfaceMesh, 5> shapes{ sphere(4), torus(1.0, 0.35, 60, 30),
    box(Vec3(-1, -0.6, -0.3), Vec3(1, 0.6, 0.3)), bowl(4, 0.2), randomSoup(200, 0.5, 3) };
  for (std::size_t n = 0; n < shapes.size(); ++n)
  {
    const DistanceGrid grid = gridAround(boundingBox(shapes[n]), { 32, 32, 32 }, 0.1);
    const SweepError error = sweepError(shapes[n], grid);
    EXPECT_LE(error.mean, 0.001) << n;
    EXPECT_LE(error.largest, 0.05) << n;
  }
}

TEST(ClosestPointSweep, IsExactWithinOneCell)
{
  const SurfaceMesh mesh = torus(1.0, 0.35, 60, 30);
  const AABBTree tree(mesh);
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 32, 32, 32 }, 0.1);
  const std::vector<Index> swept = sweepClosestTriangles(mesh, tree, grid);
  forEachSample(grid, Execution(),
    [&](GridIndex sample, const Vec3& point)
    {
      const double exact = tree.closest(point).at.squaredDistance;
      if (std::sqrt(exact) < 0.99 * grid.spacing.x())
      {
        const Index triangle = swept[static_cast<std::size_t>(sample)];
        EXPECT_NEAR(
          closestPointOnTriangle(point, tree.triangle(triangle)).squaredDistance, exact, 1e-12);
      }
    });
}

TEST(ClosestPointSweep, AcceptsCellsThatAreNoCubes)
{
  const DistanceGrid grid = gridOver(Box(Vec3(-2, -2, -2), Vec3(2, 2, 2)), { 40, 20, 28 });
  const SweepError error = sweepError(sphere(4), grid);
  EXPECT_LE(error.mean, 0.001);
  EXPECT_LE(error.largest, 0.05);
}

TEST(ClosestPointSweep, IsNearlyExactInGridsThatCutOrMissTheSurface)
{
  const SurfaceMesh mesh = torus(1.0, 0.35, 60, 30);
  const Vec3 ends[] = { Vec3(0, 0, 0), Vec3(2, 1, 0.3), Vec3(3, 3, 3), Vec3(4, 4, 4),
    Vec3(-0.3, -0.3, -0.1), Vec3(0.3, 0.3, 0.1) };
  for (std::size_t n = 0; n < 6; n += 2)
  {
    const DistanceGrid grid = gridAround(Box(ends[n], ends[n + 1]), { 24, 20, 16 }, 0.0);
    const SweepError error = sweepError(mesh, grid);
    EXPECT_LE(error.mean, 0.001) << n;
    EXPECT_LE(error.largest, 0.05) << n;
  }
}

TEST(ClosestPointSweep, IsExactOnSlicesAndLines)
{
  for (const std::array<int, 3>& size :
    { std::array<int, 3>{ 30, 30, 1 }, { 1, 30, 1 }, { 1, 1, 1 } })
  {
    const SurfaceMesh mesh = sphere(3);
    const SweepError error = sweepError(mesh, gridAround(boundingBox(mesh), size, 0.1));
    EXPECT_LE(error.largest, 1e-6);
  }
}

TEST(ClosestPointSweep, IsTheSameForAnyNumberOfThreads)
{
  const SurfaceMesh mesh = torus(1.0, 0.35, 40, 20);
  const AABBTree tree(mesh);
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 40, 36, 28 }, 0.1);
  const std::vector<Index> serial = sweepClosestTriangles(mesh, tree, grid);
  for (const int threads : { 1, 2, 8 })
  {
    EXPECT_EQ(sweepClosestTriangles(mesh, tree, grid, threadedExecution(threads, 7)), serial);
  }
}

TEST(ClosestPointSweep, StopsWhenAsked)
{
  const SurfaceMesh mesh = sphere(3);
  const AABBTree tree(mesh);
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 20, 20, 20 }, 0.1);
  int questions = 0;
  const Execution stopping(nullptr, nullptr, [&] { return ++questions > 5; });
  EXPECT_THROW(sweepClosestTriangles(mesh, tree, grid, stopping), Cancelled);
}
