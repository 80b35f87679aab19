// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/ClosestPoint/ClosestOnGrid.h"

#include "Checks/AllTriangles.h"
#include "Distance/ClosestTriangles.h"
#include "Errors.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "ThreadedExecution.h"
#include "Trees/TriangleGeometry.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

constexpr double Everywhere = std::numeric_limits<double>::infinity();

/// Compares with all triangles: the distance, and that of the triangle that is named.
void expectExact(const SurfaceMesh& mesh, const DistanceGrid& grid)
{
  const GridClosest closest = closestOnGrid(mesh, grid, Everywhere);
  // What FramedTriangle promises, with the largest edge there can be.
  const double size = boundingBox(mesh).diagonal().norm();
  const double least = 1e-7 * size + 1e-6 * grid.spacing.maxCoeff();
  forEachSample(grid, Execution(),
    [&](GridIndex sample, const Vec3& point)
    {
      const auto s = static_cast<std::size_t>(sample);
      const double exact = checks::distanceToAll(mesh, point);
      const double tolerance = 2e-6 * exact + least;
      ASSERT_NEAR(closest.distance[s], exact, tolerance);
      const Triangle named = triangleOf(mesh, closest.triangle[s]);
      ASSERT_NEAR(
        std::sqrt(closestPointOnTriangle(point, named).squaredDistance), exact, tolerance);
    });
}

SurfaceMesh pointCloud(int count)
{
  SurfaceMesh mesh;
  const SurfaceMesh soup = randomSoup(count, 1.0, 5);
  for (Index face = 0; face < soup.faceCount(); ++face)
  {
    const Index point = mesh.addPoint(soup.facePoint(face, 0));
    mesh.addFace({ point, point, point });
  }
  return mesh;
}

} // namespace

TEST(ClosestOnGrid, IsExactForShapesSoupsAndPoints)
{
  const SurfaceMesh shapes[] = { sphere(3), torus(30, 15, 1.0, 0.35),
    box(Vec3(-1, -0.6, -0.3), Vec3(1, 0.6, 0.3)), bowl(3, 0.2), randomSoup(200, 0.5, 3),
    pointCloud(150), merged(sphere(2), reversed(sphere(2, 0.5))) };
  for (const SurfaceMesh& mesh : shapes)
  {
    expectExact(mesh, gridAround(boundingBox(mesh), { 23, 21, 22 }, 0.1));
  }
}

TEST(ClosestOnGrid, IsExactInsideASphereWhereAllTrianglesAreAlmostAsClose)
{
  const SurfaceMesh mesh = sphere(3);
  expectExact(
    mesh, gridAround(Box(Vec3(-0.05, -0.05, -0.05), Vec3(0.05, 0.05, 0.05)), { 9, 9, 9 }, 0.0));
}

TEST(ClosestOnGrid, IsExactInGridsThatCutOrMissTheSurface)
{
  const SurfaceMesh mesh = torus(30, 15, 1.0, 0.35);
  const Vec3 ends[] = { Vec3(0, 0, 0), Vec3(2, 1, 0.3), Vec3(3, 3, 3), Vec3(4, 4, 4),
    Vec3(-0.3, -0.3, -0.1), Vec3(0.3, 0.3, 0.1), Vec3(1, 0, 0), Vec3(1.0001, 1e-4, 1e-4) };
  for (std::size_t n = 0; n < 8; n += 2)
  {
    expectExact(mesh, gridAround(Box(ends[n], ends[n + 1]), { 14, 10, 9 }, 0.0));
  }
}

TEST(ClosestOnGrid, IsExactForCellsThatAreNoCubesAndForSlicesAndLines)
{
  const SurfaceMesh mesh = sphere(3);
  expectExact(mesh, gridOver(Box(Vec3(-2, -2, -2), Vec3(2, 2, 2)), { 30, 10, 18 }));
  for (const std::array<int, 3>& size :
    { std::array<int, 3>{ 30, 30, 1 }, { 1, 30, 1 }, { 1, 1, 1 } })
  {
    expectExact(mesh, gridAround(boundingBox(mesh), size, 0.1));
  }
}

TEST(ClosestOnGrid, IsExactForDegenerateTrianglesAndLongOnes)
{
  SurfaceMesh mesh;
  mesh.addPoint(Vec3(0, 0, 0));
  mesh.addPoint(Vec3(100, 1, 2));
  mesh.addPoint(Vec3(50, 0.5, 1));
  mesh.addPoint(Vec3(-40, 80, 3));
  mesh.addFace({ 0, 1, 2 }); // a segment
  mesh.addFace({ 0, 0, 0 });
  mesh.addFace({ 0, 1, 3 });
  mesh.addFace({ 3, 3, 1 });
  expectExact(mesh, gridAround(Box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), { 12, 12, 12 }, 0.1));
  expectExact(mesh, gridAround(boundingBox(mesh), { 20, 20, 20 }, 0.1));
}

TEST(ClosestOnGrid, OfAPartIsThatOfTheWholeBitForBit)
{
  const SurfaceMesh mesh = torus(60, 30, 1.0, 0.35);
  DistanceGrid grid = gridAround(boundingBox(mesh), { 40, 37, 21 }, 0.1);
  grid.extent = { -3, 36, 2, 38, 0, 20 }; // extents may begin anywhere
  const GridClosest whole = closestOnGrid(mesh, grid, Everywhere);
  for (const Extent& extent :
    { Extent{ 1, 5, 7, 38, 20, 20 }, { -3, -3, 2, 2, 0, 20 }, { 30, 36, 30, 38, 3, 17 } })
  {
    const DistanceGrid part = grid.part(extent);
    const GridClosest alone = closestOnGrid(mesh, part, Everywhere);
    for (int k = extent[4]; k <= extent[5]; ++k)
    {
      for (int j = extent[2]; j <= extent[3]; ++j)
      {
        for (int i = extent[0]; i <= extent[1]; ++i)
        {
          const auto a = static_cast<std::size_t>(part.index(i, j, k));
          const auto w = static_cast<std::size_t>(grid.index(i, j, k));
          ASSERT_EQ(alone.distance[a], whole.distance[w]);
          ASSERT_EQ(alone.triangle[a], whole.triangle[w]);
        }
      }
    }
  }
}

TEST(ClosestOnGrid, IsTheSameForAnyNumberOfThreadsAndAnyInstructions)
{
  const SurfaceMesh mesh = torus(40, 20, 1.0, 0.35);
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 40, 36, 28 }, 0.1);
  const GridClosest serial = closestOnGrid(mesh, grid, Everywhere);
  for (const int threads : { 1, 2, 8 })
  {
    const GridClosest other = closestOnGrid(mesh, grid, Everywhere, threadedExecution(threads, 7));
    EXPECT_EQ(other.distance, serial.distance);
    EXPECT_EQ(other.triangle, serial.triangle);
  }
  const GridClosest plain = closestOnGrid(mesh, grid, Everywhere, {}, Instructions::Any);
  EXPECT_EQ(plain.distance, serial.distance);
  EXPECT_EQ(plain.triangle, serial.triangle);
}

TEST(ClosestOnGrid, WithABandIsTheSameInItAndLeavesOutWhatIsFarAway)
{
  const SurfaceMesh mesh = sphere(4, 0.3);
  const DistanceGrid grid = gridAround(Box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), { 64, 64, 64 }, 0.0);
  const double band = 3.0 * grid.spacing.x();
  const GridClosest all = closestOnGrid(mesh, grid, Everywhere);
  const GridClosest banded = closestOnGrid(mesh, grid, band);
  std::size_t leftOut = 0;
  for (std::size_t s = 0; s < all.distance.size(); ++s)
  {
    if (banded.triangle[s] == NoIndex)
    {
      ++leftOut;
      EXPECT_EQ(banded.distance[s], std::numeric_limits<float>::infinity());
      EXPECT_GT(all.distance[s], band);
      continue;
    }
    EXPECT_EQ(banded.distance[s], all.distance[s]);
    EXPECT_EQ(banded.triangle[s], all.triangle[s]);
  }
  EXPECT_GT(leftOut, all.distance.size() / 2);
}

TEST(ClosestOnGrid, KnowsWhereFloatsEnd)
{
  const SurfaceMesh mesh = sphere(2);
  EXPECT_TRUE(isWithinReachOfFloats(mesh, gridAround(boundingBox(mesh), { 512, 512, 512 }, 0.1)));
  EXPECT_FALSE(isWithinReachOfFloats(
    mesh, gridAround(Box(Vec3(0, 0, 0), Vec3(1e-9, 1e-9, 1e-9)), { 8, 8, 8 }, 0.1)));
}

TEST(ClosestOnGrid, StopsWhenAsked)
{
  const SurfaceMesh mesh = sphere(3);
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 64, 64, 64 }, 0.1);
  int questions = 0;
  const Execution stopping(nullptr, nullptr, [&] { return ++questions > 8; });
  EXPECT_THROW(closestOnGrid(mesh, grid, Everywhere, stopping), Cancelled);
}
