// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/PseudonormalSign.h"

#include "Distance/ClosestPoint/ClosestOnGrid.h"
#include "Distance/ClosestTriangles.h"
#include "Distance/Signs/Pseudonormals.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "Trees/TriangleGeometry.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

UnsignedDistance measured(const SurfaceMesh& mesh, const DistanceGrid& grid, double band)
{
  GridClosest closest = closestOnGrid(mesh, grid, band);
  return { std::move(closest.distance), std::move(closest.triangle), {} };
}

/// The side of every sample for itself.
std::vector<char> sampleBySample(
  const DistanceTarget& target, const DistanceGrid& grid, const UnsignedDistance& samples)
{
  const Pseudonormals normals(target.mesh, target.orientation.edgeOfCorner);
  std::vector<char> inside(samples.triangle.size());
  forEachSample(grid, Execution(),
    [&](GridIndex sample, const Vec3& point)
    {
      const Index face = samples.triangle[static_cast<std::size_t>(sample)];
      inside[static_cast<std::size_t>(sample)] =
        normals.isInside(point, face, closestPointOnTriangle(point, triangleOf(target.mesh, face)));
    });
  return inside;
}

DistanceGrid centeredGrid(const DistanceTarget& target, const std::array<int, 3>& dimensions)
{
  return gridAround(boundingBox(target.mesh), dimensions, 0.1);
}

constexpr double Everywhere = std::numeric_limits<double>::infinity();

} // namespace

TEST(PseudonormalSign, CarriedAlongRowsIsThatOfEverySampleForItself)
{
  for (const SurfaceMesh& mesh : { sphere(3), torus(40, 20, 1.0, 0.35), reversed(sphere(2)),
         box(Vec3(-1, -0.6, -0.3), Vec3(1, 0.6, 0.3)), torus(60, 6, 1.0, 0.02) })
  {
    const DistanceTarget target = makeDistanceTarget(mesh);
    ASSERT_TRUE(needsTrianglesNearSurfaceOnly(target.orientation));
    const DistanceGrid grid = centeredGrid(target, { 33, 30, 28 });
    const UnsignedDistance samples = measured(target.mesh, grid, Everywhere);
    EXPECT_EQ(insideByPseudonormal(target, grid, samples), sampleBySample(target, grid, samples));
  }
}

TEST(PseudonormalSign, NeedsTrianglesNearTheSurfaceOnly)
{
  const DistanceTarget target = makeDistanceTarget(sphere(4, 0.5));
  for (const DistanceGrid& grid :
    { gridAround(Box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), { 50, 50, 50 }, 0.0),
      gridAround(Box(Vec3(-0.2, -0.2, -0.2), Vec3(0.2, 0.2, 0.2)), { 90, 90, 90 }, 0.0) })
  {
    const UnsignedDistance all = measured(target.mesh, grid, Everywhere);
    const UnsignedDistance near = measured(target.mesh, grid, 3.0 * grid.spacing.x());
    EXPECT_EQ(near.triangle.front(), NoIndex);
    EXPECT_EQ(insideByPseudonormal(target, grid, near), sampleBySample(target, grid, all));
  }
}

TEST(PseudonormalSign, OfOpenSurfacesIsFoundForEverySample)
{
  const DistanceTarget target = makeDistanceTarget(bowl(3, 0.2));
  ASSERT_FALSE(needsTrianglesNearSurfaceOnly(target.orientation));
  const DistanceGrid grid = centeredGrid(target, { 31, 28, 30 });
  const UnsignedDistance samples = measured(target.mesh, grid, Everywhere);
  EXPECT_EQ(insideByPseudonormal(target, grid, samples), sampleBySample(target, grid, samples));
}

TEST(PseudonormalSign, TakesRowsSampleBySampleWhereTheSurfaceCutsThroughItself)
{
  // A torus whose tube is thicker than its ring: closed and oriented, but it meets itself.
  const DistanceTarget target = makeDistanceTarget(torus(40, 30, 0.5, 0.9));
  ASSERT_TRUE(needsTrianglesNearSurfaceOnly(target.orientation));
  const DistanceGrid grid = centeredGrid(target, { 41, 41, 41 });
  const UnsignedDistance samples = measured(target.mesh, grid, Everywhere);
  const std::vector<char> rows = insideByPseudonormal(target, grid, samples);
  const std::vector<char> single = sampleBySample(target, grid, samples);
  // Rows that contradict themselves equal the samples for themselves; the rest may not, deep in
  // the space that is enclosed twice. Outside of it all there is no doubt.
  forEachSample(grid, Execution(),
    [&](GridIndex sample, const Vec3& point)
    {
      const auto s = static_cast<std::size_t>(sample);
      const double tube = std::hypot(std::hypot(point.x(), point.y()) - 0.5, point.z());
      if (tube > 0.92)
      {
        EXPECT_FALSE(rows[s]);
      }
      if (single[s] != rows[s])
      {
        EXPECT_LT(tube, 0.9);
      }
    });
}
