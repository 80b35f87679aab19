// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// What a result has lost of its target's holes, slits and parts: found, and said with its place.

#include "LostTopology/LostTopology.h"

#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"
#include "ShrinkWrap/Shortcomings.h"
#include "ShrinkWrap/WrapRuns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <set>
#include <string>

using namespace evolving;

namespace
{

SurfaceMesh inTriangles(const SurfaceMesh& mesh)
{
  std::mt19937 generator(1);
  return shapes::triangulated(mesh, generator);
}

/// Three long, with holes of a unit side by side.
SurfaceMesh slab(int holes)
{
  return inTriangles(shapes::slabWithHoles(holes));
}

SurfaceMesh block(const Vec3& low, const Vec3& high)
{
  return inTriangles(shapes::box(low, high));
}

constexpr double HoleWidth = 0.3;

/// Along a side a web of a unit, a hole, a web, ...
double alongSide(double cells)
{
  return (1.0 + HoleWidth) * std::floor(0.5 * cells) + std::fmod(cells, 2.0);
}

/// With three rows of three square holes.
SurfaceMesh plate()
{
  std::set<std::array<int, 3>> cells;
  for (int i = 0; i < 49; ++i)
  {
    const bool isHole = i / 7 % 2 == 1 && i % 7 % 2 == 1;
    if (!isHole)
    {
      cells.insert({ i / 7, i % 7, 0 });
    }
  }
  SurfaceMesh mesh = inTriangles(shapes::cellSurface(cells));
  for (Vec3& p : mesh.points)
  {
    p = Vec3(alongSide(p.x()), alongSide(p.y()), 0.4 * p.z());
  }
  return mesh;
}

/// The row and the column of the plate's hole that a point is in.
std::array<int, 2> holeAt(const Vec3& p)
{
  std::array<int, 2> hole{ -1, -1 };
  for (int k = 0; k < 3; ++k)
  {
    const double from = alongSide(2.0 * k + 1.0);
    for (int axis = 0; axis < 2; ++axis)
    {
      hole[at(axis)] = p[axis] > from && p[axis] < from + HoleWidth ? k : hole[at(axis)];
    }
  }
  EXPECT_GE(std::min(hole[0], hole[1]), 0) << p.transpose();
  return hole;
}

/// Of square section, three long, open along its top from x = 2 to 2 + width.
SurfaceMesh slitTube(double width)
{
  std::set<std::array<int, 3>> cells;
  for (int i = 0; i < 45; ++i)
  {
    const std::array<int, 3> cell{ i % 5, i / 5 % 3, i / 15 };
    const bool isBore = cell[1] == 1 && cell[0] > 0 && cell[0] < 4;
    const bool isSlit = cell[1] == 2 && cell[0] == 2;
    if (!isBore && !isSlit)
    {
      cells.insert(cell);
    }
  }
  SurfaceMesh tube = inTriangles(shapes::cellSurface(cells));
  for (Vec3& point : tube.points)
  {
    point.x() -= point.x() > 2.5 ? 1.0 - width : 0.0;
  }
  return tube;
}

/// Wraps a target and tells what was lost of it.
std::optional<LostTopology> lostBy(const SurfaceMesh& target, const ShrinkWrapOptions& options)
{
  const ShrinkWrapProblem problem = prepareShrinkWrap(target, options);
  return examineWrap(wraps::run(problem), problem).lost;
}

bool isIn(const Vec3& point, const Vec3& low, const Vec3& high)
{
  return Box(low, high).contains(point);
}

bool says(const LostTopology& lost, const std::string& words)
{
  return inWords(lost).find(words) != std::string::npos;
}

} // namespace

TEST(LostTopology, IsNoneOfASurfaceThatHasItAll)
{
  EXPECT_FALSE(findLostTopology(slab(3), slab(3), 0.3));
  const SurfaceMesh ball = shapes::sphere(2);
  // A cavity cannot be seen; nor does it matter how faces are turned.
  const SurfaceMesh hollow = shapes::merged(ball, reversed(shapes::sphere(2, 0.5)));
  EXPECT_FALSE(findLostTopology(hollow, ball, 0.3));
  EXPECT_FALSE(findLostTopology(reversed(ball), ball, 0.3));
}

TEST(LostTopology, IsNotKnownOfTargetsThatBoundNoSolid)
{
  const SurfaceMesh ball = shapes::sphere(2);
  const SurfaceMesh two = shapes::merged(ball, shapes::sphere(2, 1.0, Vec3(3.0, 0.0, 0.0)));
  EXPECT_TRUE(findLostTopology(two, ball, 0.3));
  EXPECT_FALSE(findLostTopology(shapes::without(two, [](Index f) { return f == 0; }), ball, 0.3));
  EXPECT_FALSE(findLostTopology(shapes::turned(two, [](Index f) { return f == 0; }), ball, 0.3));
  // From one of the sides the first triangle of neither is in the other one.
  for (const double side : { -1.9, 1.9 })
  {
    const SurfaceMesh other = shapes::sphere(2, 1.0, Vec3(side, 0.0, 0.0));
    EXPECT_FALSE(findLostTopology(shapes::merged(ball, other), ball, 0.3));
  }
  EXPECT_FALSE(findLostTopology(two, {}, 0.3));
}

TEST(LostTopology, IsHolesThatElementsAreTooLargeFor)
{
  for (const double scale : { 1.0, 1000.0 })
  {
    const SurfaceMesh target = shapes::transformed(plate(), scale, Vec3::Zero());
    const auto lost = lostBy(target, wraps::quick(0.5 * scale, 24));
    ASSERT_TRUE(lost);
    EXPECT_EQ(lost->genus, 9);
    EXPECT_EQ(lost->genusOfResult, 0);
    std::set<std::array<int, 2>> holes;
    for (const ChangedPlace& place : lost->places.filled)
    {
      EXPECT_NEAR(place.width, HoleWidth * scale, 1e-6 * scale);
      holes.insert(holeAt(place.middle / scale));
    }
    EXPECT_EQ(lost->places.filled.size(), 9u);
    EXPECT_EQ(holes.size(), 9u);
    EXPECT_TRUE(says(*lost,
      "The target has genus 9 in 1 part, the result genus 0 in 1 part: 9 holes or gaps were "
      "closed"))
      << inWords(*lost);
    EXPECT_TRUE(says(*lost, " and 6 more; use ")) << inWords(*lost);
  }
}

TEST(LostTopology, IsBroughtBackByTheEdgeLengthThatIsAdvised)
{
  const auto lost = lostBy(plate(), wraps::quick(0.5, 24));
  ASSERT_TRUE(lost);
  EXPECT_GT(lost->remedy.edgeLength, HoleWidth / 2.0);
  ShrinkWrapOptions better = wraps::quick(lost->remedy.edgeLength, 24);
  better.sampleDimensions.fill(lost->remedy.samples.value_or(24));
  EXPECT_FALSE(lostBy(plate(), better));
}

TEST(LostTopology, IsBroughtBackByTheNumberOfPointsThatIsAdvised)
{
  ShrinkWrapOptions options;
  options.preserveFeatures = FeaturePreservation::Off;
  options.targetNumberOfPoints = 400;
  const auto lost = lostBy(plate(), options);
  ASSERT_TRUE(lost);
  EXPECT_FALSE(lost->remedy.samples) << inWords(*lost);
  EXPECT_EQ(lost->remedy.edgeLength, 0.0);
  EXPECT_LT(lost->remedy.points, 3000);
  options.targetNumberOfPoints = lost->remedy.points;
  EXPECT_FALSE(lostBy(plate(), options));
}

TEST(LostTopology, IsBlamedOnSamplesWhereTheyAreTooFew)
{
  const auto lost = lostBy(slab(2), wraps::quick(0.4, 7));
  ASSERT_TRUE(lost);
  EXPECT_EQ(lost->remedy.samples, std::optional<int>(0));
  EXPECT_EQ(lost->remedy.edgeLength, 0.0);
  EXPECT_TRUE(says(*lost, "; use SampleDimensions of 0.")) << inWords(*lost);
}

TEST(LostTopology, IsTheGapBetweenPartsThatWereJoined)
{
  const SurfaceMesh two = shapes::merged(
    block(Vec3::Zero(), Vec3::Ones()), block(Vec3(1.05, 0.0, 0.0), Vec3(2.05, 1.0, 1.0)));
  const auto lost = lostBy(two, wraps::quick(0.2, 24));
  ASSERT_TRUE(lost);
  EXPECT_EQ(lost->parts, 2);
  EXPECT_EQ(lost->partsOfResult, 1);
  ASSERT_EQ(lost->places.filled.size(), 1u);
  EXPECT_NEAR(lost->places.filled[0].width, 0.05, 1e-9);
  EXPECT_TRUE(isIn(lost->places.filled[0].middle, Vec3(1.0, 0.0, 0.0), Vec3(1.05, 1.0, 1.0)));
  EXPECT_TRUE(says(*lost, "1 hole or gap was closed, 0.05 wide at (1.025 ")) << inWords(*lost);
}

TEST(LostTopology, IsTheSlitOfATube)
{
  const auto lost = lostBy(slitTube(0.1), wraps::quick(0.4, 28));
  ASSERT_TRUE(lost);
  EXPECT_EQ(lost->genus, 0);
  EXPECT_EQ(lost->genusOfResult, 1);
  ASSERT_EQ(lost->places.filled.size(), 1u);
  EXPECT_NEAR(lost->places.filled[0].width, 0.1, 1e-9);
  EXPECT_TRUE(isIn(lost->places.filled[0].middle, Vec3(2.0, 2.0, 0.0), Vec3(2.1, 3.0, 3.0)));
  // Wide enough it stays open.
  EXPECT_FALSE(lostBy(slitTube(1.0), wraps::quick(0.4, 28)));
}

TEST(LostTopology, IsAPartThatVanishes)
{
  const Vec3 away(4.0, 0.0, 0.0);
  const SurfaceMesh both = shapes::merged(shapes::sphere(3), shapes::sphere(1, 0.02, away));
  const auto lost = lostBy(both, wraps::quick(0.3, 24));
  ASSERT_TRUE(lost);
  ASSERT_EQ(lost->places.missingParts.size(), 1u);
  EXPECT_LT((lost->places.missingParts[0].middle - away).norm(), 1e-9);
  EXPECT_TRUE(lost->places.filled.empty());
  EXPECT_TRUE(lost->places.missing.empty());
  EXPECT_TRUE(says(*lost, "in 2 parts, the result genus 0 in 1 part: 1 part is missing, 0.0"))
    << inWords(*lost);
}

TEST(LostTopology, IsNotBroughtBackByNumbersThatNobodyCanAfford)
{
  const SurfaceMesh two = shapes::merged(
    block(Vec3::Zero(), Vec3::Ones()), block(Vec3(1.001, 0.0, 0.0), Vec3(2.001, 1.0, 1.0)));
  ShrinkWrapOptions options = wraps::quick(0.2, 24);
  const auto lost = lostBy(two, options);
  ASSERT_TRUE(lost);
  EXPECT_TRUE(says(*lost, "; triangles cannot be so small: ")) << inWords(*lost);
  EXPECT_FALSE(says(*lost, "; use ")) << inWords(*lost);
  options.gapSize = 0.01;
  EXPECT_FALSE(lostBy(two, options));
}

TEST(LostTopology, IsNoneWhereItWasKeptOrClosedOnPurpose)
{
  EXPECT_FALSE(lostBy(slab(2), wraps::quick(0.2, 48)));
  ShrinkWrapOptions closing = wraps::quick(0.4, 24);
  closing.gapSize = 2.0;
  EXPECT_FALSE(lostBy(slab(2), closing));
  ShrinkWrapOptions offset = wraps::quick(0.4, 24);
  offset.offsetDistance = 0.8;
  EXPECT_FALSE(lostBy(slab(2), offset));
}

TEST(LostTopology, IsSaidByNumbersWhereNoPlaceIsKnown)
{
  LostTopology lost;
  lost.parts = 1;
  lost.partsOfResult = 4;
  EXPECT_TRUE(says(lost, "in 4 parts: places thinner than a triangle were lost."));
  lost.genus = 2;
  lost.remedy.edgeLength = 0.5;
  EXPECT_TRUE(says(lost, "closed or lost; use a TargetEdgeLength of 0.5."));
  lost.genusOfResult = 3;
  lost.remedy.isStart = true;
  EXPECT_TRUE(says(
    lost, "were joined, or parts lost; use the Isosurface start and a TargetEdgeLength of 0.5."));
}
