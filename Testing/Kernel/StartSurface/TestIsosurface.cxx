// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/Isosurface.h"

#include "Checks/ClosedSurface.h"
#include "Errors.h"
#include "Mesh/Angles.h"
#include "Mesh/MeshQuality.h"
#include "Mesh/MeshTopology.h"
#include "Shapes/SampledOnGrid.h"
#include "StartSurface/QuadSplitting.h"
#include "StartSurface/SurfaceNets.h"
#include "StartSurface/WellComposed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

SurfaceMesh sphereSurface(int n, const IsosurfaceOptions& options)
{
  const Vec3 centre(0.03, -0.05, 0.01);
  const DistanceGrid grid = cubicGrid(n);
  return isosurface(
    grid, sampled(grid, [&](const Vec3& p) { return (p - centre).norm() - 0.7; }), options);
}

} // namespace

TEST(Isosurface, SphereIsClosedOutwardAndConvergesInSecondOrder)
{
  for (const bool triangles : { true, false })
  {
    IsosurfaceOptions options;
    options.triangles = triangles;
    double lastVolumeError = 0.0;
    double lastAreaError = 0.0;
    for (const int n : { 17, 33, 65 })
    {
      const SurfaceMesh mesh = sphereSurface(n, options);
      const TopologySummary summary = checks::expectClosedManifold(mesh);
      EXPECT_EQ(summary.components, 1);
      EXPECT_EQ(summary.genus(), 0);
      EXPECT_EQ(mesh.hasOnlyTriangles(), triangles);
      const double volumeError = std::abs(signedVolume(mesh) / (4.0 / 3.0 * Pi * 0.343) - 1.0);
      const double areaError = std::abs(surfaceArea(mesh) / (4.0 * Pi * 0.49) - 1.0);
      if (n > 17)
      {
        EXPECT_GT(lastVolumeError / volumeError, 3.3);
        EXPECT_GT(lastAreaError / areaError, 3.3);
      }
      lastVolumeError = volumeError;
      lastAreaError = areaError;
    }
    EXPECT_LT(lastVolumeError, 0.003);
    EXPECT_LT(lastAreaError, 0.003);
  }
}

TEST(Isosurface, TorusHasGenusOne)
{
  const DistanceGrid grid = cubicGrid(41);
  const std::vector<float> field =
    sampled(grid, [](const Vec3& p) { return torusDistance(p, 0.6, 0.2); });
  const SurfaceMesh mesh = isosurface(grid, field, {});
  EXPECT_EQ(checks::expectClosedManifold(mesh).genus(), 1);
  EXPECT_NEAR(signedVolume(mesh), 2.0 * Pi * Pi * 0.6 * 0.04, 0.02);
}

TEST(Isosurface, IsAClosedManifoldForAnyNoise)
{
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    DistanceGrid grid = cubicGrid(8);
    grid.extent = { 0, 5, 0, 6, 0, 7 };
    IsosurfaceOptions options;
    options.isoValue = (seed % 20 + 0.5) / 20.0;
    options.triangles = seed % 3 != 0;
    options.relaxationSweeps = static_cast<int>(seed % 4);
    options.fillCavities = seed % 5 == 0;
    const SurfaceMesh mesh = isosurface(grid, noise(grid, seed), options);
    const TopologySummary summary = checks::expectClosedManifold(mesh);
    EXPECT_GT(signedVolume(mesh), 0.0) << seed;
    for (Index face = 0; face < mesh.faceCount(); ++face)
    {
      ASSERT_GT(smallestAngle(mesh, face), 0.0) << seed;
    }
    if (options.fillCavities)
    {
      EXPECT_GE(summary.genus(), 0);
    }
  }
}

TEST(Isosurface, VerticesOfALinearFieldLieOnItsPlane)
{
  DistanceGrid grid = cubicGrid(12);
  grid.spacing = Vec3(0.2, 0.15, 0.3);
  const Vec3 normal = Vec3(1.0, 0.4, -0.3).normalized();
  const auto plane = [&](const Vec3& p) { return normal.dot(p) - 0.11; };
  const SurfaceMesh mesh = isosurface(grid, sampled(grid, plane), {});
  const Box inner(grid.origin + 1.001 * grid.spacing, grid.origin + Vec3(9.999 * grid.spacing));
  int checked = 0;
  int exact = 0;
  for (const Vec3& point : mesh.points)
  {
    if (inner.contains(point) && std::abs(plane(point)) < 0.1)
    {
      // Up to rounding, but where a crossing was kept away from a sample.
      EXPECT_NEAR(plane(point), 0.0, 0.02 * grid.spacing.maxCoeff());
      exact += std::abs(plane(point)) < 1e-7 ? 1 : 0;
      ++checked;
    }
  }
  EXPECT_GT(checked, 50);
  EXPECT_GT(exact, 0.8 * checked);
}

TEST(Isosurface, RegionsAtTheBorderAreWalledThere)
{
  const DistanceGrid grid = cubicGrid(9);
  const SurfaceMesh full = isosurface(grid, std::vector<float>(729, -1.0F), {});
  EXPECT_EQ(checks::expectClosedManifold(full).genus(), 0);
  // The wall stands 1/50 of a cell outside the border, its edges and corners a little rounded.
  EXPECT_NEAR(signedVolume(full), std::pow(2.0 + 0.04 * grid.spacing.x(), 3), 0.01);
  const Box box = boundingBox(full);
  EXPECT_NEAR((box.max() - Vec3::Ones()).cwiseAbs().maxCoeff(), 0.0, 0.021 * grid.spacing.x());

  DistanceGrid slice = cubicGrid(9);
  slice.extent = { 0, 8, 0, 8, 4, 4 };
  const SurfaceMesh slab =
    isosurface(slice, sampled(slice, [](const Vec3& p) { return p.norm() - 0.6; }), {});
  EXPECT_EQ(checks::expectClosedManifold(slab).genus(), 0);
}

TEST(Isosurface, ExtentAndOriginDescribeTheSameSurface)
{
  const DistanceGrid grid = cubicGrid(21);
  DistanceGrid shifted = grid;
  shifted.extent = { -7, 13, 100, 120, 3, 23 };
  shifted.origin -= Vec3(-7.0, 100.0, 3.0).cwiseProduct(grid.spacing);
  const std::vector<float> field =
    sampled(grid, [](const Vec3& p) { return p.cwiseAbs().sum() - 0.8; });
  const SurfaceMesh a = isosurface(grid, field, {});
  const SurfaceMesh b = isosurface(shifted, field, {});
  ASSERT_EQ(a.cornerVertices, b.cornerVertices);
  for (std::size_t v = 0; v < a.points.size(); ++v)
  {
    EXPECT_NEAR((a.points[v] - b.points[v]).norm(), 0.0, 1e-12);
  }
}

TEST(Isosurface, FillCavitiesKeepsTheOuterSurfaceOnly)
{
  const DistanceGrid grid = cubicGrid(31);
  const std::vector<float> field = sampled(
    grid, [](const Vec3& p) { return std::min(std::abs(p.norm() - 0.7) - 0.1, p.norm() - 0.2); });
  IsosurfaceOptions options;
  EXPECT_EQ(checks::expectClosedManifold(isosurface(grid, field, options)).components, 3);
  options.fillCavities = true;
  const SurfaceMesh outer = isosurface(grid, field, options);
  EXPECT_EQ(checks::expectClosedManifold(outer).components, 1);
  EXPECT_NEAR(signedVolume(outer), 4.0 / 3.0 * Pi * 0.512, 0.05);
}

TEST(Isosurface, RelaxationKeepsVerticesInTheirCellsAndImprovesAngles)
{
  const DistanceGrid grid = cubicGrid(33);
  const std::vector<float> field =
    sampled(grid, [](const Vec3& p) { return torusDistance(p, 0.6, 0.25); });
  const InsideSamples samples(grid, field, 0.0);
  SurfaceNet net = surfaceNet(grid, samples);
  const AngleSummary before = summarizeAngles(splitQuads(net.mesh));
  relaxWithinCells(net, 10);
  ASSERT_EQ(net.cellOfVertex.size(), net.mesh.points.size());
  for (std::size_t v = 0; v < net.cellOfVertex.size(); ++v)
  {
    EXPECT_TRUE(net.cellOfVertex[v].contains(net.mesh.points[v]));
    EXPECT_LT(std::abs(torusDistance(net.mesh.points[v], 0.6, 0.25)), grid.spacing.norm());
  }
  const AngleSummary after = summarizeAngles(splitQuads(net.mesh));
  EXPECT_GT(after.mean, before.mean + 2.0);
  EXPECT_GT(after.smallest, 20.0);
}

TEST(Isosurface, NothingBelowTheIsoValueGivesAnEmptyMesh)
{
  const DistanceGrid grid = cubicGrid(4);
  EXPECT_EQ(isosurface(grid, std::vector<float>(64, 1.0F), {}).faceCount(), 0);
  EXPECT_EQ(isosurface(grid, std::vector<float>(64, 0.0F), {}).faceCount(), 0);
}

TEST(Isosurface, RefusesBadGridsAndOptions)
{
  const std::vector<float> field(64, 1.0F);
  DistanceGrid flat = cubicGrid(4);
  flat.spacing.y() = 0.0;
  EXPECT_THROW(isosurface(flat, field, {}), InputError);
  IsosurfaceOptions options;
  options.relaxationSweeps = -1;
  EXPECT_THROW(isosurface(cubicGrid(4), field, options), InputError);
  options.relaxationSweeps = 0;
  options.isoValue = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(isosurface(cubicGrid(4), field, options), InputError);
}

TEST(Isosurface, StopsWhenAskedAndReportsRisingProgress)
{
  const DistanceGrid grid = cubicGrid(9);
  const std::vector<float> field = sampled(grid, [](const Vec3& p) { return p.norm() - 0.5; });
  const auto serial = [](std::int64_t count, const std::function<void(std::int64_t)>& task)
  {
    for (std::int64_t i = 0; i < count; ++i)
    {
      task(i);
    }
  };
  double last = 0.0;
  int reports = 0;
  const auto record = [&](double fraction)
  {
    EXPECT_GE(fraction, last);
    last = fraction;
    ++reports;
  };
  isosurface(grid, field, {}, Execution(serial, record, [] { return false; }));
  EXPECT_EQ(last, 1.0);
  const int complete = reports;
  reports = 0;
  last = 0.0;
  const auto stopEarly = [&] { return reports > 3; };
  EXPECT_THROW(isosurface(grid, field, {}, Execution(serial, record, stopEarly)), Cancelled);
  EXPECT_LT(reports, complete);
}
