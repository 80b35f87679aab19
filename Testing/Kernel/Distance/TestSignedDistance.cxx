// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/SignedDistance.h"

#include "Distance/ClosestTriangles.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/SampledOnGrid.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "ThreadedExecution.h"
#include "Trees/TriangleGeometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

SignedDistanceResult distanceOn(const DistanceGrid& grid, const SurfaceMesh& mesh,
  DistanceMethod method, SignMethod sign = SignMethod::Automatic)
{
  SignedDistanceOptions options;
  options.method = method;
  options.sign = sign;
  return signedDistance(mesh, grid, grid.extent, options);
}

} // namespace

TEST(SignedDistance, OfABoxIsAnalytic)
{
  const Vec3 half(1.0, 0.7, 0.4);
  const SurfaceMesh mesh = box(-half, half);
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 33, 27, 22 }, 0.15);
  for (const auto method : { DistanceMethod::BruteForce, DistanceMethod::ClosestPoint })
  {
    const double tolerance = method == DistanceMethod::BruteForce ? 1e-6 : 1e-5 * grid.spacing.x();
    const SignedDistanceResult result = distanceOn(grid, mesh, method);
    forEachSample(grid, Execution(),
      [&](GridIndex s, const Vec3& point)
      {
        EXPECT_NEAR(
          result.distance[static_cast<std::size_t>(s)], boxDistance(point, half), tolerance);
      });
  }
}

TEST(SignedDistance, OfASphereConvergesWithTheMesh)
{
  // Triangles of edge e stay within e^2 / 8 of the sphere.
  const DistanceGrid grid = gridAround(Box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), { 20, 20, 20 }, 0.3);
  double last = 0.0;
  for (const int level : { 2, 3, 4 })
  {
    const SignedDistanceResult result = distanceOn(grid, sphere(level), DistanceMethod::BruteForce);
    double error = 0.0;
    forEachSample(grid, Execution(),
      [&](GridIndex s, const Vec3& point)
      {
        const double exact = point.norm() - 1.0;
        const auto found = static_cast<double>(result.distance[static_cast<std::size_t>(s)]);
        error = std::max(error, std::abs(found - exact));
      });
    if (last > 0.0)
    {
      EXPECT_NEAR(std::log2(last / error), 2.0, 0.35);
    }
    last = error;
  }
}

TEST(SignedDistance, FastSweepingIsOfFirstOrder)
{
  const SurfaceMesh mesh = torus(120, 60, 1.0, 0.4);
  double errors[2];
  int n = 40;
  for (double& error : errors)
  {
    const DistanceGrid grid = gridAround(boundingBox(mesh), { n, n, n / 2 }, 0.1);
    const auto swept = distanceOn(grid, mesh, DistanceMethod::FastSweeping).distance;
    double sum = 0.0;
    forEachSample(grid, Execution(),
      [&](GridIndex s, const Vec3& point)
      {
        const double ring = Vec3(point.x(), point.y(), 0.0).norm() - 1.0;
        const double exact = std::hypot(ring, point.z()) - 0.4;
        const auto found = static_cast<double>(swept[static_cast<std::size_t>(s)]);
        sum += (found - exact) * (found - exact);
      });
    error = std::sqrt(sum / static_cast<double>(swept.size()));
    n *= 2;
  }
  EXPECT_GE(std::log2(errors[0] / errors[1]), 0.85);
}

TEST(SignedDistance, SweepsOnGridsThatCutOrMissTheSurface)
{
  const SurfaceMesh mesh = sphere(4);
  const DistanceGrid grids[] = { gridAround(
                                   Box(Vec3(0, 0, 0), Vec3(1.5, 1.5, 1.5)), { 25, 25, 25 }, 0.0),
    gridAround(Box(Vec3(2, 2, 2), Vec3(3, 3, 3)), { 25, 25, 25 }, 0.0) };
  for (const DistanceGrid& grid : grids)
  {
    const auto swept = distanceOn(grid, mesh, DistanceMethod::FastSweeping).distance;
    forEachSample(grid, Execution(),
      [&](GridIndex s, const Vec3& point) {
        EXPECT_NEAR(swept[static_cast<std::size_t>(s)], point.norm() - 1.0, 1.5 * grid.spacing.x());
      });
  }
}

TEST(SignedDistance, HasSlopeOneAwayFromTheMedialAxis)
{
  const SurfaceMesh mesh = sphere(5);
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 40, 40, 40 }, 0.2);
  const auto distance = distanceOn(grid, mesh, DistanceMethod::ClosestPoint).distance;
  const auto at = [&](int i, int j, int k)
  { return static_cast<double>(distance[static_cast<std::size_t>(grid.index(i, j, k))]); };
  for (int k = 1; k < 39; ++k)
  {
    for (int j = 1; j < 39; ++j)
    {
      for (int i = 1; i < 39; ++i)
      {
        const Vec3 difference(at(i + 1, j, k) - at(i - 1, j, k), at(i, j + 1, k) - at(i, j - 1, k),
          at(i, j, k + 1) - at(i, j, k - 1));
        if (grid.point(i, j, k).norm() > 0.3)
        {
          EXPECT_NEAR((difference / (2.0 * grid.spacing.x())).norm(), 1.0, 0.02);
        }
      }
    }
  }
}

TEST(SignedDistance, FillsTheArraysAskedFor)
{
  const SurfaceMesh mesh = sphere(3, 1.0, Vec3(5, 0, 0));
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 15, 15, 15 }, 0.2);
  for (const auto method : { DistanceMethod::ClosestPoint, DistanceMethod::FastSweeping })
  {
    SignedDistanceOptions options;
    options.method = method;
    options.closestPoint = options.closestFace = options.gradient = true;
    const SignedDistanceResult result = signedDistance(mesh, grid, grid.extent, options);
    forEachSample(grid, Execution(),
      [&](GridIndex sample, const Vec3& point)
      {
        const auto s = static_cast<std::size_t>(sample);
        const Vec3 closest(result.closestPoint[3 * s], result.closestPoint[3 * s + 1],
          result.closestPoint[3 * s + 2]);
        const Vec3 gradient(
          result.gradient[3 * s], result.gradient[3 * s + 1], result.gradient[3 * s + 2]);
        const double slack = method == DistanceMethod::ClosestPoint ? 1e-5 : 1.5 * grid.spacing.x();
        EXPECT_NEAR((point - closest).norm(), std::abs(result.distance[s]), slack);
        EXPECT_NEAR(gradient.norm(), 1.0, 1e-5);
        EXPECT_GE(gradient.dot(point - closest) * double(result.distance[s]), -1e-5);
        const Index face = result.closestFace[s];
        ASSERT_GE(face, 0);
        ASSERT_LT(face, mesh.faceCount());
        const Triangle triangle{ { mesh.facePoint(face, 0), mesh.facePoint(face, 1),
          mesh.facePoint(face, 2) } };
        EXPECT_NEAR((closestPointOnTriangle(point, triangle).point - closest).norm(), 0.0, 1e-5);
      });
  }
}

TEST(SignedDistance, LeavesArraysNotAskedForEmpty)
{
  const DistanceGrid grid = gridAround(Box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), { 5, 5, 5 }, 0.2);
  const SignedDistanceResult result = distanceOn(grid, sphere(1), DistanceMethod::ClosestPoint);
  EXPECT_EQ(result.distance.size(), 125U);
  EXPECT_TRUE(result.closestPoint.empty());
  EXPECT_TRUE(result.closestFace.empty());
  EXPECT_TRUE(result.gradient.empty());
}

TEST(SignedDistance, ClampsToTheBand)
{
  const SurfaceMesh mesh = sphere(3);
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 24, 24, 24 }, 0.2);
  SignedDistanceOptions options;
  const auto whole = signedDistance(mesh, grid, grid.extent, options).distance;
  for (const double width : { 2.5, 1e-300, 1e300 })
  {
    options.bandWidth = width;
    const auto banded = signedDistance(mesh, grid, grid.extent, options).distance;
    const auto band = static_cast<float>(width * grid.spacing.x());
    for (std::size_t s = 0; s < whole.size(); ++s)
    {
      EXPECT_EQ(banded[s], std::clamp(whole[s], -band, band));
    }
  }
}

TEST(SignedDistance, SmoothingKeepsAPlaneAndRoundsAnEdge)
{
  const SurfaceMesh mesh = box(Vec3(-1, -1, -1), Vec3(1, 1, 1));
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 41, 41, 41 }, 0.1);
  SignedDistanceOptions options;
  const auto sharp = signedDistance(mesh, grid, grid.extent, options).distance;
  options.smoothingSigma = 1.0;
  options.gradient = true;
  const auto smooth = signedDistance(mesh, grid, grid.extent, options);
  const auto onFace = static_cast<std::size_t>(grid.index(37, 20, 20));
  EXPECT_NEAR(smooth.distance[onFace], sharp[onFace], 1e-5);
  EXPECT_NEAR(smooth.gradient[3 * onFace], 1.0, 1e-4);
  // Inside, at a right-angled edge, the minimum of two planes loses by smoothing.
  const auto atEdge = static_cast<std::size_t>(grid.index(32, 32, 20));
  EXPECT_GT(smooth.distance[atEdge], sharp[atEdge] + 0.1F * static_cast<float>(grid.spacing.x()));
}

TEST(SignedDistance, LosesNothingFarFromTheOrigin)
{
  // Coordinates that a double can hold exactly, so that nothing is lost by moving the mesh.
  const Vec3 far(1 << 24, -(1 << 23), 1 << 25);
  SurfaceMesh near = torus(30, 16, 1.0, 0.4);
  for (Vec3& point : near.points)
  {
    point = (point * 1048576.0).array().round() / 1048576.0;
  }
  SurfaceMesh moved = near;
  for (Vec3& point : moved.points)
  {
    point += far;
  }
  DistanceGrid grid = gridAround(Box(Vec3(-2, -2, -1), Vec3(2, 2, 1)), { 17, 17, 9 }, 0.0);
  DistanceGrid movedGrid = grid;
  movedGrid.origin += far;
  for (const auto method :
    { DistanceMethod::BruteForce, DistanceMethod::ClosestPoint, DistanceMethod::FastSweeping })
  {
    EXPECT_EQ(
      distanceOn(movedGrid, moved, method).distance, distanceOn(grid, near, method).distance);
  }
}

TEST(SignedDistance, ScalesWithTheModel)
{
  const SurfaceMesh unit = torus(30, 16, 1.0, 0.4);
  const DistanceGrid unitGrid = gridAround(boundingBox(unit), { 16, 16, 12 }, 0.1);
  for (const double scale : { 1e-30, 1e30 })
  {
    SurfaceMesh mesh = unit;
    for (Vec3& point : mesh.points)
    {
      point *= scale;
    }
    const DistanceGrid grid = gridAround(boundingBox(mesh), { 16, 16, 12 }, 0.1);
    for (const auto method :
      { DistanceMethod::BruteForce, DistanceMethod::ClosestPoint, DistanceMethod::FastSweeping })
    {
      const auto expected = distanceOn(unitGrid, unit, method).distance;
      const auto found = distanceOn(grid, mesh, method).distance;
      for (std::size_t s = 0; s < found.size(); ++s)
      {
        EXPECT_NEAR(static_cast<double>(found[s]) / scale, expected[s], 1e-4);
      }
    }
  }
}

TEST(SignedDistance, OfASoupIsThatOfItsMesh)
{
  const SurfaceMesh mesh = torus(30, 16, 1.0, 0.4);
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 20, 20, 12 }, 0.1);
  const auto fromMesh = distanceOn(grid, mesh, DistanceMethod::BruteForce);
  const auto fromSoup = distanceOn(grid, soupOf(mesh), DistanceMethod::BruteForce);
  EXPECT_EQ(fromSoup.sign, SignMethod::Pseudonormal);
  for (std::size_t s = 0; s < fromMesh.distance.size(); ++s)
  {
    EXPECT_NEAR(fromSoup.distance[s], fromMesh.distance[s], 1e-6F);
  }
}

TEST(SignedDistance, HasTheSameBitsForAnyNumberOfThreads)
{
  const SurfaceMesh mesh = without(sphere(3), [](Index face) { return face % 9 == 0; });
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 30, 26, 28 }, 0.1);
  for (const auto method :
    { DistanceMethod::BruteForce, DistanceMethod::ClosestPoint, DistanceMethod::FastSweeping })
  {
    for (const auto sign :
      { SignMethod::WindingNumber, SignMethod::Pseudonormal, SignMethod::FloodFill })
    {
      SignedDistanceOptions options;
      options.method = method;
      options.sign = sign;
      options.gradient = options.closestFace = true;
      options.smoothingSigma = 0.8;
      const auto serial = signedDistance(mesh, grid, grid.extent, options);
      for (const int threads : { 1, 2, 8 })
      {
        const auto result =
          signedDistance(mesh, grid, grid.extent, options, threadedExecution(threads, 11));
        EXPECT_EQ(result.distance, serial.distance);
        EXPECT_EQ(result.closestFace, serial.closestFace);
        EXPECT_EQ(result.gradient, serial.gradient);
      }
    }
  }
}
