// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/CreaseSizes.h"

#include "Features/CapturableCreases.h"
#include "Mesh/Angles.h"
#include "Shapes/CreasedShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

CreaseSizing between(double smallest, double largest)
{
  CreaseSizing sizing;
  sizing.smallest = smallest;
  sizing.largest = largest;
  sizing.step = 0.25 * largest;
  return sizing;
}

CreaseSizes sizesOf(const SurfaceMesh& mesh, const CreaseSizing& sizing)
{
  const TargetTriangles target(mesh);
  return { target, SharpEdges(target, 45.0, false), sizing };
}

/// Of a polygon with many corners on a circle of radius 1.
constexpr double OnCircle = 0.4;

SurfaceMesh plate(double thickness)
{
  return box(Vec3::Zero(), Vec3(1.0, 1.0, thickness));
}

} // namespace

TEST(CreaseSizes, AreLargeBesideStraightCreasesFarApart)
{
  const CreaseSizes sizes = sizesOf(plate(1.0), between(0.01, 0.2));
  EXPECT_EQ(sizes.smallest(), 0.2);
  for (const Vec3& point : { Vec3(0.0, 0.0, 0.0), Vec3(0.5, 0.0, 0.0), Vec3(0.5, 0.5, 1.0) })
  {
    EXPECT_EQ(sizes.at(point), 0.2);
  }
}

TEST(CreaseSizes, LetSomeElementsFitBetweenTwoCreases)
{
  const CreaseSizing sizing = between(0.01, 0.2);
  for (const double thickness : { 0.05, 0.1, 0.2 })
  {
    const CreaseSizes sizes = sizesOf(plate(thickness), sizing);
    EXPECT_NEAR(sizes.at(Vec3(0.5, 0.0, 0.0)), thickness / sizing.across, 1e-9);
    EXPECT_NEAR(sizes.at(Vec3(0.5, 0.0, thickness)), thickness / sizing.across, 1e-9);
  }
}

TEST(CreaseSizes, DoNotAskForSmallElementsInCorners)
{
  // Creases that meet come near to each other, but elements of any size fill a right angle.
  const CreaseSizes sizes = sizesOf(plate(0.7), between(0.01, 0.2));
  for (const double t : { 0.01, 0.05, 0.1 })
  {
    EXPECT_EQ(sizes.at(Vec3(t, 0.0, 0.0)), 0.2);
  }
}

TEST(CreaseSizes, AreSmallInCornersThatNoElementFills)
{
  // Half the width of the corner at a sample, (k + 1/2) / 20 from it, is the smallest that counts.
  const CreaseSizing sizing = between(0.01, 0.2);
  for (const double degrees : { 8.0, 15.0, 20.0, 25.0, 40.0 })
  {
    const double slope = std::tan(degrees * RadiansPerDegree);
    const CreaseSizes sizes =
      sizesOf(extruded({ Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, slope, 0) }, 1.0), sizing);
    const double width = std::sin(degrees * RadiansPerDegree) * 0.1;
    if (degrees < 22.0)
    {
      EXPECT_NEAR(
        sizes.at(Vec3(0.1, 0.0, 0.0)), width / sizing.across, 0.3 * width / sizing.across);
    }
    else
    {
      EXPECT_EQ(sizes.at(Vec3(0.1, 0.0, 0.0)), 0.2) << degrees;
    }
  }
}

TEST(CreaseSizes, FollowTheBendsOfACrease)
{
  const SurfaceMesh mesh = extruded(regularPolygon(96), 3.0);
  const CreaseSizes sizes = sizesOf(mesh, between(0.05, 0.6));
  for (const Index v : { 0, 17, 50 })
  {
    EXPECT_NEAR(sizes.at(mesh.points[at(v)]), OnCircle, 0.02);
  }
  EXPECT_NEAR(sizes.smallest(), OnCircle, 0.02);
}

TEST(CreaseSizes, FollowTheBendsOfFacesWithoutCreases)
{
  // Half way up a cylinder, far from both rims.
  const SurfaceMesh mesh = extruded(regularPolygon(96), 8.0);
  const CreaseSizes sizes = sizesOf(mesh, between(0.05, 0.6));
  EXPECT_NEAR(sizes.at(Vec3(1.0, 0.0, 4.0)), OnCircle, 0.02);
  EXPECT_EQ(sizesOf(mesh, between(0.45, 0.6)).smallest(), 0.45);
}

TEST(CreaseSizes, GrowAwayFromCreases)
{
  const CreaseSizing sizing = between(0.01, 0.5);
  const CreaseSizes sizes = sizesOf(plate(0.1), sizing);
  const double beside = 0.1 / sizing.across;
  EXPECT_NEAR(sizes.at(Vec3(0.5, 0.2, 0.1)), beside + 0.2 * sizing.growth, 0.03);
  EXPECT_EQ(sizes.at(Vec3(0.5, 0.5, 3.0)), 0.5);
}

TEST(CreaseSizes, StayBetweenTheirBounds)
{
  const CreaseSizes sizes = sizesOf(plate(0.01), between(0.1, 0.3));
  EXPECT_EQ(sizes.smallest(), 0.1);
  EXPECT_EQ(sizes.largest(), 0.3);
  EXPECT_EQ(sizes.at(Vec3(0.5, 0.0, 0.0)), 0.1);
}

TEST(CreaseSizes, WithOtherLongestEdgesAreTheSameBelowThose)
{
  CreaseSizing sizing = between(0.01, 0.4);
  sizing.step = 0.05;
  const CreaseSizes shortened = sizesOf(plate(0.1), sizing).withLargest(0.2);
  sizing.largest = 0.2;
  const CreaseSizes expected = sizesOf(plate(0.1), sizing);
  EXPECT_EQ(shortened.largest(), 0.2);
  EXPECT_EQ(shortened.smallest(), expected.smallest());
  for (const Vec3& point : { Vec3(0.5, 0.0, 0.0), Vec3(0.5, 0.2, 0.1), Vec3(0.5, 0.5, 0.1) })
  {
    EXPECT_EQ(shortened.at(point), expected.at(point));
  }
}

TEST(CreaseSizes, AreLargeEverywhereWithoutCreases)
{
  const SurfaceMesh mesh = box(Vec3::Zero(), Vec3::Ones());
  const TargetTriangles target(mesh);
  SharpEdges none(target, 45.0, false);
  for (const Index edge : none.list())
  {
    none.leaveOut(edge);
  }
  const CreaseSizes sizes(target, none, between(0.1, 0.3));
  EXPECT_EQ(sizes.at(Vec3(0.2, 0.3, 1.0)), 0.3);
}

TEST(CreaseSizes, GoWithTheScaleOfTheTarget)
{
  const SurfaceMesh mesh = plate(0.1);
  for (const double scale : { 1e-6, 1e6 })
  {
    const SurfaceMesh scaled = transformed(mesh, scale, Vec3(scale, 0.0, 0.0));
    const CreaseSizes sizes = sizesOf(scaled, between(0.01 * scale, 0.2 * scale));
    const double expected = sizesOf(mesh, between(0.01, 0.2)).at(Vec3(0.5, 0.1, 0.1));
    EXPECT_NEAR(sizes.at(scale * Vec3(1.5, 0.1, 0.1)), scale * expected, 1e-9 * scale);
  }
}
