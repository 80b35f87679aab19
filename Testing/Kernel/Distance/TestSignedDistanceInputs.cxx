// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/SignedDistance.h"

#include "Checks/Refusal.h"
#include "Distance/ClosestTriangles.h"
#include "Errors.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

constexpr DistanceMethod Methods[] = { DistanceMethod::ClosestPoint, DistanceMethod::FastSweeping,
  DistanceMethod::BruteForce };
constexpr SignMethod Signs[] = { SignMethod::Automatic, SignMethod::FloodFill,
  SignMethod::WindingNumber, SignMethod::Pseudonormal, SignMethod::Unsigned };

/// Runs all methods with all signs and all arrays; everything must be finite and plausible.
void expectFinite(const SurfaceMesh& mesh, const DistanceGrid& grid)
{
  for (const DistanceMethod method : Methods)
  {
    for (const SignMethod sign : Signs)
    {
      SignedDistanceOptions options;
      options.method = method;
      options.sign = sign;
      options.closestPoint = options.closestFace = options.gradient = true;
      const auto result = signedDistance(mesh, grid, grid.extent, options);
      ASSERT_EQ(result.distance.size(), static_cast<std::size_t>(grid.sampleCount()));
      EXPECT_FALSE(result.signReason.empty());
      const auto isFinite = [](float value) { return std::isfinite(value); };
      EXPECT_TRUE(std::all_of(result.distance.begin(), result.distance.end(), isFinite));
      EXPECT_TRUE(std::all_of(result.closestPoint.begin(), result.closestPoint.end(), isFinite));
      EXPECT_TRUE(std::all_of(result.gradient.begin(), result.gradient.end(), isFinite));
      for (const Index face : result.closestFace)
      {
        ASSERT_GE(face, 0);
        ASSERT_LT(face, mesh.faceCount());
      }
    }
  }
}

DistanceGrid roomyGrid(int n)
{
  return gridAround(Box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), { n, n, n }, 0.2);
}

/// The sentence of the InputError that the call throws.
std::string complaint(
  const SurfaceMesh& mesh, const DistanceGrid& grid, const SignedDistanceOptions& options)
{
  return checks::refusalOf([&] { signedDistance(mesh, grid, grid.extent, options); });
}

} // namespace

TEST(SignedDistanceInputs, OneTriangleIsASheet)
{
  const SurfaceMesh mesh = triangleMesh(Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 1, 0));
  expectFinite(mesh, roomyGrid(12));
  SignedDistanceOptions options;
  const auto result = signedDistance(mesh, roomyGrid(12), roomyGrid(12).extent, options);
  EXPECT_EQ(result.sign, SignMethod::WindingNumber);
  // A flat sheet encloses nothing.
  EXPECT_GE(*std::min_element(result.distance.begin(), result.distance.end()), 0.0F);
}

TEST(SignedDistanceInputs, DegenerateTrianglesCountAsSegmentsAndPoints)
{
  // A collinear triangle beside a sphere: the distance to it is that to a segment.
  const SurfaceMesh segment =
    triangleMesh(Vec3(-0.9, -0.9, 0.9), Vec3(0.9, -0.9, 0.9), Vec3(0, -0.9, 0.9));
  const SurfaceMesh mesh = merged(sphere(2, 0.5), segment);
  expectFinite(mesh, roomyGrid(12));
  const DistanceGrid grid = roomyGrid(20);
  SignedDistanceOptions options;
  options.sign = SignMethod::Unsigned;
  const auto result = signedDistance(mesh, grid, grid.extent, options);
  forEachSample(grid, Execution(),
    [&](GridIndex s, const Vec3& point)
    {
      const Vec3 foot(std::clamp(point.x(), -0.9, 0.9), -0.9, 0.9);
      EXPECT_LE(result.distance[static_cast<std::size_t>(s)],
        (point - foot).norm() + 0.05 * grid.spacing.x());
    });
}

TEST(SignedDistanceInputs, OnlyDegenerateTriangles)
{
  expectFinite(triangleMesh(Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 0)), roomyGrid(9));
}

TEST(SignedDistanceInputs, DuplicateFacesOfAnyOrientationChangeNothing)
{
  const SurfaceMesh mesh = sphere(3);
  const DistanceGrid grid = roomyGrid(16);
  const SurfaceMesh some = without(mesh, [](Index face) { return face % 4 != 0; });
  for (const DistanceMethod method : Methods)
  {
    for (const SignMethod sign : Signs)
    {
      SignedDistanceOptions options;
      options.method = method;
      options.sign = sign;
      const auto expected = signedDistance(mesh, grid, grid.extent, options);
      for (const SurfaceMesh& doubled :
        { merged(mesh, some), merged(mesh, reversed(some)), merged(mesh, reversed(mesh)) })
      {
        const auto result = signedDistance(doubled, grid, grid.extent, options);
        EXPECT_EQ(result.distance, expected.distance);
        EXPECT_EQ(result.sign, expected.sign);
      }
    }
  }
}

TEST(SignedDistanceInputs, FlatMeshes)
{
  SurfaceMesh square;
  square.points = { Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 0) };
  square.addFace({ 0, 1, 2, 3 });
  expectFinite(square, gridAround(boundingBox(square), { 12, 12, 12 }, 0.1));
  expectFinite(square, gridAround(boundingBox(square), { 12, 12, 1 }, 0.1));
  expectFinite(square, gridAround(boundingBox(square), { 12, 12, 12 }, 0.0));
}

TEST(SignedDistanceInputs, OpenAndNonManifoldAndRandomSurfaces)
{
  expectFinite(bowl(3, 0.2), roomyGrid(14));
  expectFinite(randomSoup(100, 0.5, 3), roomyGrid(14));
  expectFinite(merged(box(Vec3(-1, -1, -1), Vec3(0, 0, 0)), box(Vec3(0, 0, -1), Vec3(1, 1, 0))),
    roomyGrid(14));
}

TEST(SignedDistanceInputs, GridsOfOneSampleAlongAxes)
{
  const SurfaceMesh mesh = sphere(2);
  for (const std::array<int, 3>& size :
    { std::array<int, 3>{ 9, 9, 1 }, { 1, 9, 9 }, { 9, 1, 1 }, { 1, 1, 1 }, { 2, 2, 2 } })
  {
    expectFinite(mesh, gridAround(boundingBox(mesh), size, 0.1));
  }
}

TEST(SignedDistanceInputs, PolygonsAreCut)
{
  SurfaceMesh cube;
  for (int corner = 0; corner < 8; ++corner)
  {
    cube.addPoint(Vec3((corner & 1) - 0.5, (corner >> 1 & 1) - 0.5, (corner >> 2) - 0.5));
  }
  cube.addFace({ 0, 2, 3, 1 });
  cube.addFace({ 4, 5, 7, 6 });
  cube.addFace({ 0, 1, 5, 4 });
  cube.addFace({ 2, 6, 7, 3 });
  cube.addFace({ 0, 4, 6, 2 });
  cube.addFace({ 1, 3, 7, 5 });
  const DistanceGrid grid = roomyGrid(15);
  SignedDistanceOptions options;
  options.closestFace = true;
  const auto result = signedDistance(cube, grid, grid.extent, options);
  EXPECT_EQ(result.sign, SignMethod::Pseudonormal);
  EXPECT_NEAR(result.distance[static_cast<std::size_t>(grid.index(7, 7, 7))], -0.5, 1e-6);
  EXPECT_EQ(result.closestFace[static_cast<std::size_t>(grid.index(14, 7, 7))], 5);
  EXPECT_EQ(result.closestFace[static_cast<std::size_t>(grid.index(7, 7, 0))], 0);
}

TEST(SignedDistanceInputs, PointsHaveAnUnsignedDistance)
{
  SurfaceMesh points;
  points.points = { Vec3(0.1, 0.2, 0.3), Vec3(-0.5, 0.4, -0.3), Vec3(0.1, 0.2, 0.3) };
  const DistanceGrid grid = roomyGrid(17);
  for (const DistanceMethod method : Methods)
  {
    SignedDistanceOptions options;
    options.method = method;
    options.closestFace = options.closestPoint = options.gradient = true;
    const auto result = signedDistance(points, grid, grid.extent, options);
    EXPECT_EQ(result.sign, SignMethod::Unsigned);
    const double slack = method == DistanceMethod::FastSweeping ? 2.5 : 1e-4;
    forEachSample(grid, Execution(),
      [&](GridIndex sample, const Vec3& point)
      {
        const auto s = static_cast<std::size_t>(sample);
        const double first = (point - points.points[0]).norm();
        const double second = (point - points.points[1]).norm();
        EXPECT_NEAR(result.distance[s], std::min(first, second), slack * grid.spacing.x());
        if (std::abs(first - second) > 0.1 * grid.spacing.x())
        {
          EXPECT_EQ(result.closestFace[s], first < second ? 0 : 1);
        }
      });
  }
}

TEST(SignedDistanceInputs, AreRefusedWithOneSentence)
{
  const DistanceGrid grid = roomyGrid(8);
  const SignedDistanceOptions standard;
  EXPECT_NE(complaint(SurfaceMesh(), grid, standard), "");
  SurfaceMesh broken = sphere(1);
  broken.points[2].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(complaint(broken, grid, standard), "");
  broken.points[2].y() = std::numeric_limits<double>::infinity();
  EXPECT_NE(complaint(broken, grid, standard), "");

  SurfaceMesh points;
  points.points = { Vec3(0, 0, 0) };
  SignedDistanceOptions flood;
  flood.sign = SignMethod::FloodFill;
  EXPECT_NE(complaint(points, grid, flood), "");

  SignedDistanceOptions sweeping;
  sweeping.method = DistanceMethod::FastSweeping;
  const DistanceGrid oblong = gridOver(Box(Vec3(-2, -2, -2), Vec3(2, 2, 2)), { 8, 16, 8 });
  EXPECT_NE(complaint(sphere(1), oblong, sweeping), "");
  EXPECT_EQ(complaint(sphere(1), oblong, standard), "");

  SignedDistanceOptions negative;
  negative.bandWidth = -1.0;
  EXPECT_NE(complaint(sphere(1), grid, negative), "");
  negative = standard;
  negative.smoothingSigma = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(complaint(sphere(1), grid, negative), "");
  EXPECT_NE(complaint(sphere(1), DistanceGrid(), standard), "");
  EXPECT_THROW(signedDistance(sphere(1), grid, { 0, 8, 0, 7, 0, 7 }, standard), InputError);
}

TEST(SignedDistanceInputs, StopsWhenAskedInEveryPhase)
{
  const SurfaceMesh mesh = bowl(3, 0.2);
  const DistanceGrid grid = roomyGrid(20);
  for (const DistanceMethod method : Methods)
  {
    SignedDistanceOptions options;
    options.method = method;
    int questions = 0;
    signedDistance(mesh, grid, grid.extent, options,
      Execution(nullptr, nullptr,
        [&]
        {
          ++questions;
          return false;
        }));
    ASSERT_GT(questions, 5);
    for (int stop = 1; stop <= questions; stop += 1 + questions / 10)
    {
      int asked = 0;
      const Execution stopping(nullptr, nullptr, [&] { return ++asked >= stop; });
      bool cancelled = false;
      try
      {
        signedDistance(mesh, grid, grid.extent, options, stopping);
      }
      catch (const Cancelled&)
      {
        cancelled = true;
      }
      // Long work asks more often, by the clock: a run on a quiet machine may ask less.
      EXPECT_EQ(cancelled, asked >= stop || stop <= questions / 2) << "at question " << stop;
      EXPECT_LE(asked, stop);
    }
  }
}

TEST(SignedDistanceInputs, ProgressRisesFromZeroToOne)
{
  for (const DistanceMethod method : Methods)
  {
    SignedDistanceOptions options;
    options.method = method;
    options.gradient = true;
    options.smoothingSigma = 1.0;
    std::vector<double> fractions;
    const Execution reporting(
      nullptr, [&](double fraction) { fractions.push_back(fraction); }, nullptr);
    signedDistance(bowl(3, 0.2), roomyGrid(20), roomyGrid(20).extent, options, reporting);
    EXPECT_EQ(fractions.front(), 0.0);
    EXPECT_EQ(fractions.back(), 1.0);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  }
}
