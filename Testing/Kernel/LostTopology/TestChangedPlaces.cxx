// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Solids of known holes, bars and parts, and what is found to be different between two of them.

#include "LostTopology/ChangedPlaces.h"

#include "LostTopology/OuterParts.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

using namespace evolving;

namespace
{

constexpr double Spacing = 0.25;

SurfaceMesh inTriangles(const SurfaceMesh& mesh)
{
  std::mt19937 generator(1);
  return shapes::triangulated(mesh, generator);
}

/// From 0 to 11, 3 and 1, with five holes of a unit: one from x = 1, one from x = 3, ...
SurfaceMesh perforated()
{
  return inTriangles(shapes::slabWithHoles(5));
}

SurfaceMesh block(const Vec3& low, const Vec3& high)
{
  return inTriangles(shapes::box(low, high));
}

/// The number of the hole of the slab that a point is in; -1 in none.
int holeAt(const Vec3& p)
{
  const int column = static_cast<int>(std::floor(p.x()));
  const bool isIn = column % 2 == 1 && p.y() > 1.0 && p.y() < 2.0 && p.z() > 0.0 && p.z() < 1.0;
  return isIn ? column / 2 : -1;
}

std::set<int> holesOf(const std::vector<ChangedPlace>& places, double scale)
{
  std::set<int> holes;
  for (const ChangedPlace& place : places)
  {
    EXPECT_NEAR(place.width, scale, 1e-9 * scale);
    holes.insert(holeAt(place.middle / scale));
  }
  return holes;
}

const std::set<int> AllHoles{ 0, 1, 2, 3, 4 };

} // namespace

TEST(ChangedPlaces, AreNoneBetweenASolidAndItself)
{
  const ChangedPlaces changed = findChangedPlaces(perforated(), perforated(), Spacing);
  EXPECT_TRUE(changed.filled.empty());
  EXPECT_TRUE(changed.missing.empty());
  EXPECT_TRUE(changed.missingParts.empty());
}

TEST(ChangedPlaces, AreAllHolesOfASlabThatHasNoneNow)
{
  for (const double scale : { 1.0, 1000.0 })
  {
    const auto scaled = [scale](const SurfaceMesh& mesh)
    { return shapes::transformed(mesh, scale, Vec3::Zero()); };
    const SurfaceMesh filled = scaled(block(Vec3::Zero(), Vec3(11.0, 3.0, 1.0)));
    // However few places there are on its walls.
    for (const double spacing : { 0.25, 4.0 })
    {
      const ChangedPlaces changed =
        findChangedPlaces(scaled(perforated()), filled, scale * spacing);
      EXPECT_EQ(changed.filled.size(), 5u);
      EXPECT_EQ(holesOf(changed.filled, scale), AllHoles);
      EXPECT_TRUE(changed.missing.empty());
    }
  }
}

TEST(ChangedPlaces, AreAllPlacesThatWereCutOutOfASlab)
{
  const ChangedPlaces changed =
    findChangedPlaces(block(Vec3::Zero(), Vec3(11.0, 3.0, 1.0)), perforated(), 0.2);
  EXPECT_EQ(changed.missing.size(), 5u);
  EXPECT_EQ(holesOf(changed.missing, 1.0), AllHoles);
  EXPECT_TRUE(changed.filled.empty());
  EXPECT_TRUE(changed.missingParts.empty());
}

TEST(ChangedPlaces, AreASlitBetweenPartsThatAreOneNow)
{
  const SurfaceMesh two = shapes::merged(
    block(Vec3::Zero(), Vec3::Ones()), block(Vec3(1.1, 0.0, 0.0), Vec3(2.1, 1.0, 1.0)));
  const ChangedPlaces changed =
    findChangedPlaces(two, block(Vec3::Zero(), Vec3(2.1, 1.0, 1.0)), Spacing);
  ASSERT_EQ(changed.filled.size(), 1u);
  EXPECT_NEAR(changed.filled[0].width, 0.1, 1e-12);
  EXPECT_NEAR(changed.filled[0].middle.x(), 1.05, 1e-12);
  EXPECT_TRUE(changed.missingParts.empty());
}

TEST(ChangedPlaces, ArePartsOfWhichNothingIsLeft)
{
  const SurfaceMesh ball = shapes::sphere(3);
  const Vec3 away(5.0, 0.0, 0.0);
  const SurfaceMesh both = shapes::merged(ball, shapes::sphere(1, 0.1, away));
  const ChangedPlaces changed = findChangedPlaces(both, ball, Spacing);
  ASSERT_EQ(changed.missingParts.size(), 1u);
  EXPECT_LT((changed.missingParts[0].middle - away).norm(), 1e-9);
  EXPECT_NEAR(changed.missingParts[0].width, 0.2 * std::sqrt(3.0), 0.05);
  EXPECT_TRUE(changed.missing.empty());
}

TEST(ChangedPlaces, AreAsWideAsTheMouthThatWasClosed)
{
  // A box with walls of a unit around a cavity of three, open through a hole of a unit.
  std::set<std::array<int, 3>> cells;
  for (int i = 0; i < 125; ++i)
  {
    const std::array<int, 3> cell{ i / 25, i / 5 % 5, i % 5 };
    const bool isWall =
      std::any_of(cell.begin(), cell.end(), [](int c) { return c == 0 || c == 4; });
    if (isWall && cell != std::array<int, 3>{ 2, 2, 4 })
    {
      cells.insert(cell);
    }
  }
  const SurfaceMesh vessel = inTriangles(shapes::cellSurface(cells));
  const ChangedPlaces changed =
    findChangedPlaces(vessel, block(Vec3::Zero(), Vec3::Constant(5.0)), 0.5);
  ASSERT_EQ(changed.filled.size(), 1u);
  EXPECT_NEAR(changed.filled[0].width, 1.0, 1e-9);
  EXPECT_GT(changed.filled[0].middle.z(), 4.0);
}

TEST(OuterParts, AreOfAHollowBallItsOuterSphereAndPointOutwards)
{
  const SurfaceMesh ball = shapes::sphere(2);
  const SurfaceMesh hollow = shapes::merged(ball, reversed(shapes::sphere(2, 0.5)));
  const SurfaceMesh outer = outerParts(hollow);
  EXPECT_EQ(outer.cornerVertices, ball.cornerVertices);
  EXPECT_EQ(outer.points.front(), ball.points.front());
  EXPECT_GT(signedVolume(outerParts(reversed(hollow))), 3.5);
  // In the cavity there may be another part, which cannot be seen either.
  const SurfaceMesh filled = shapes::merged(hollow, shapes::sphere(1, 0.2));
  EXPECT_EQ(outerParts(filled).faceCount(), ball.faceCount());
  const SurfaceMesh beside = shapes::merged(hollow, shapes::sphere(1, 0.2, Vec3(2.0, 0.0, 0.0)));
  EXPECT_EQ(outerParts(beside).faceCount(), ball.faceCount() + shapes::sphere(1).faceCount());
}
