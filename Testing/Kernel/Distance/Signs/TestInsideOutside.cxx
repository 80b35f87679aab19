// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/InsideOutside.h"

#include "Distance/SignedDistance.h"

#include "Distance/ClosestTriangles.h"
#include "Distance/Signs/WindingNumber.h"

#include "Errors.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

SignMethod automatic(const SurfaceMesh& mesh)
{
  const SignChoice choice = chooseSignMethod(SignMethod::Automatic, makeDistanceTarget(mesh));
  EXPECT_FALSE(choice.reason.empty());
  EXPECT_EQ(choice.reason.back(), '.');
  return choice.method;
}

/// The samples inside by one method, on the distances of brute force.
std::vector<char> inside(const SurfaceMesh& mesh, const DistanceGrid& grid, SignMethod method)
{
  SignedDistanceOptions options;
  options.method = DistanceMethod::BruteForce;
  options.sign = method;
  const SignedDistanceResult result = signedDistance(mesh, grid, grid.extent, options);
  EXPECT_EQ(result.sign, method);
  std::vector<char> flags;
  for (const float distance : result.distance)
  {
    flags.push_back(distance < 0.0F);
  }
  return flags;
}

long countInside(const std::vector<char>& flags)
{
  return std::count(flags.begin(), flags.end(), char(1));
}

} // namespace

TEST(ChooseSignMethod, FollowsTheTopology)
{
  EXPECT_EQ(automatic(sphere(2)), SignMethod::Pseudonormal);
  EXPECT_EQ(automatic(torus(12, 8, 1.0, 0.3)), SignMethod::Pseudonormal);
  EXPECT_EQ(automatic(reversed(sphere(2))), SignMethod::Pseudonormal);
  EXPECT_EQ(
    automatic(turned(sphere(2), [](Index f) { return f % 2 == 0; })), SignMethod::Pseudonormal);
  EXPECT_EQ(automatic(merged(sphere(2), sphere(2, 1.0, Vec3(3, 0, 0)))), SignMethod::Pseudonormal);
  EXPECT_EQ(automatic(merged(sphere(2), sphere(2, 1.0, Vec3(1, 0, 0)))), SignMethod::WindingNumber);
  EXPECT_EQ(automatic(bowl(3, 0.3)), SignMethod::WindingNumber);
  EXPECT_EQ(automatic(merged(box(Vec3(0, 0, 0), Vec3(1, 1, 1)), box(Vec3(1, 1, 0), Vec3(2, 2, 1)))),
    SignMethod::WindingNumber);
  SurfaceMesh points;
  points.points = { Vec3(0, 0, 0), Vec3(1, 1, 1) };
  EXPECT_EQ(automatic(points), SignMethod::Unsigned);
}

TEST(ChooseSignMethod, GivesPointsNoInside)
{
  SurfaceMesh points;
  points.points = { Vec3(0, 0, 0), Vec3(1, 1, 1) };
  const DistanceTarget target = makeDistanceTarget(points);
  EXPECT_EQ(chooseSignMethod(SignMethod::Unsigned, target).method, SignMethod::Unsigned);
  for (const SignMethod method :
    { SignMethod::FloodFill, SignMethod::WindingNumber, SignMethod::Pseudonormal })
  {
    EXPECT_THROW(chooseSignMethod(method, target), InputError);
  }
}

TEST(SamplesInside, AllMethodsAgreeOnClosedSurfaces)
{
  const SurfaceMesh shapes[] = { sphere(3), torus(40, 20, 1.0, 0.35),
    box(Vec3(-1, -0.7, -0.4), Vec3(1, 0.7, 0.4)),
    merged(sphere(2), reversed(sphere(2, 1.0, Vec3(2.5, 0.1, 0)))),
    turned(torus(40, 20, 1.0, 0.35), [](Index face) { return face % 3 == 0; }) };
  for (const SurfaceMesh& mesh : shapes)
  {
    for (const SurfaceMesh& oriented : { mesh, reversed(mesh) })
    {
      const DistanceGrid grid = gridAround(boundingBox(mesh), { 31, 26, 28 }, 0.07);
      const std::vector<char> expected = inside(oriented, grid, SignMethod::Pseudonormal);
      EXPECT_GT(countInside(expected), 500);
      EXPECT_EQ(inside(oriented, grid, SignMethod::WindingNumber), expected);
      EXPECT_EQ(inside(oriented, grid, SignMethod::FloodFill), expected);
    }
  }
}

TEST(SamplesInside, AllMethodsAgreeWhereTheGridCutsTheSurface)
{
  const SurfaceMesh mesh = torus(40, 20, 1.0, 0.35);
  const DistanceGrid grids[] = { gridAround(
                                   Box(Vec3(0, 0, -0.1), Vec3(1.5, 1, 0.4)), { 24, 20, 15 }, 0.0),
    gridAround(boundingBox(mesh), { 40, 40, 1 }, 0.1) };
  for (const DistanceGrid& grid : grids)
  {
    const std::vector<char> expected = inside(mesh, grid, SignMethod::Pseudonormal);
    EXPECT_GT(countInside(expected), 100);
    EXPECT_EQ(inside(mesh, grid, SignMethod::WindingNumber), expected);
    EXPECT_EQ(inside(mesh, grid, SignMethod::FloodFill), expected);
  }
}

TEST(SamplesInside, WindingNumberAndFloodUniteOverlappingShells)
{
  const SurfaceMesh mesh = merged(sphere(3), sphere(3, 1.0, Vec3(1, 0, 0)));
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 31, 26, 26 }, 0.1);
  const std::vector<char> winding = inside(mesh, grid, SignMethod::WindingNumber);
  const std::vector<char> flood = inside(mesh, grid, SignMethod::FloodFill);
  forEachSample(grid, Execution(),
    [&](GridIndex sample, const Vec3& point)
    {
      const double distance = std::min(point.norm(), (point - Vec3(1, 0, 0)).norm()) - 1.0;
      if (std::abs(distance) > 0.02)
      {
        EXPECT_EQ(winding[static_cast<std::size_t>(sample)] != 0, distance < 0.0);
      }
      // Hidden surface within a cell of an outer one confuses the flood.
      if (std::abs(distance) > 2.0 * grid.spacing.x())
      {
        EXPECT_EQ(flood[static_cast<std::size_t>(sample)] != 0, distance < 0.0);
      }
    });
}

TEST(SamplesInside, ACavityIsOutsideExceptForTheFlood)
{
  const SurfaceMesh mesh = merged(sphere(3), reversed(sphere(3, 0.5)));
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 27, 27, 27 }, 0.1);
  const auto middle = static_cast<std::size_t>(grid.index(13, 13, 13));
  EXPECT_FALSE(inside(mesh, grid, SignMethod::Pseudonormal)[middle]);
  EXPECT_FALSE(inside(mesh, grid, SignMethod::WindingNumber)[middle]);
  EXPECT_TRUE(inside(mesh, grid, SignMethod::FloodFill)[middle]);
}

TEST(SamplesInside, WindingNumberClosesHoles)
{
  // A sphere without every eleventh triangle.
  const SurfaceMesh mesh = without(sphere(4), [](Index face) { return face % 11 == 0; });
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 25, 25, 25 }, 0.1);
  for (const SurfaceMesh& oriented : { mesh, reversed(mesh) })
  {
    const std::vector<char> winding = inside(oriented, grid, SignMethod::WindingNumber);
    forEachSample(grid, Execution(),
      [&](GridIndex sample, const Vec3& point)
      {
        if (std::abs(point.norm() - 1.0) > 0.1)
        {
          EXPECT_EQ(winding[static_cast<std::size_t>(sample)] != 0, point.norm() < 1.0);
        }
      });
  }
}

TEST(SamplesInside, WindingNumberIsEvaluatedWhereverItMayHaveChanged)
{
  // The runs along rows give what the evaluation at every sample gives.
  for (const SurfaceMesh& mesh : { bowl(4, 0.1), randomSoup(300, 0.5, 3), sphere(3) })
  {
    const DistanceGrid grid = gridAround(boundingBox(mesh), { 30, 24, 26 }, 0.1);
    const std::vector<char> runs = inside(mesh, grid, SignMethod::WindingNumber);
    const DistanceTarget target = makeDistanceTarget(mesh);
    const AABBTree tree(target.mesh);
    const WindingNumber winding(tree.triangles());
    forEachSample(grid, Execution(),
      [&](GridIndex sample, const Vec3& point)
      {
        const bool expected = winding.at(point - target.center) > 0.5;
        EXPECT_EQ(runs[static_cast<std::size_t>(sample)] != 0, expected);
      });
  }
}
