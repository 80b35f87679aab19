// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/FloatPoints.h"

#include "Mesh/MeshQuality.h"
#include "Shapes/Draws.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace evolving
{

using namespace evolving::shapes;

namespace
{

SurfaceMesh sphereAt(const Vec3& center, double radius)
{
  SurfaceMesh mesh = unitIcosphere(3);
  for (Vec3& point : mesh.points)
  {
    point = center + radius * point;
  }
  return mesh;
}

double angleLostToFloats(const SurfaceMesh& mesh)
{
  SurfaceMesh rounded = mesh;
  rounded.points = roundedToFloats(mesh.points);
  return summarizeAngles(mesh).mean - summarizeAngles(rounded).mean;
}

TEST(FloatPoints, PointsBecomeWhatFloatsHave)
{
  const std::vector<Vec3> rounded = roundedToFloats({ Vec3(0.1, 1.0, 16777217.0) });
  EXPECT_EQ(rounded[0], Vec3(static_cast<double>(0.1f), 1.0, 16777216.0));
}

/// One loop that narrows and widens was compiled wrongly, for numbers that depend on the count.
TEST(FloatPoints, NoPointIsLeftAsItIs)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (std::size_t count = 0; count < 40; ++count)
  {
    std::vector<Vec3> points(count);
    for (Vec3& point : points)
    {
      point = shapes::drawnVector(coordinate, random);
    }
    const std::vector<Vec3> rounded = roundedToFloats(points);
    for (std::size_t i = 0; i < count; ++i)
    {
      for (Eigen::Index axis = 0; axis < 3; ++axis)
      {
        volatile float narrow = static_cast<float>(points[i][axis]);
        EXPECT_EQ(rounded[i][axis], static_cast<double>(narrow));
      }
    }
  }
}

TEST(FloatPoints, AreWrongForSmallElementsFarAway)
{
  EXPECT_TRUE(floatsHold(sphereAt(Vec3::Zero(), 1.0)));
  EXPECT_TRUE(floatsHold(sphereAt(Vec3(1000.0, -500.0, 20.0), 1.0)));
  EXPECT_FALSE(floatsHold(sphereAt(Vec3(6e5, 5e6, 700.0), 10.0)));
  EXPECT_TRUE(floatsHold(sphereAt(Vec3(6e5, 5e6, 700.0), 10000.0)));
}

/// The size of the elements over the distance counts, in any unit.
TEST(FloatPoints, TheUnitDoesNotMatter)
{
  for (const double unit : { 1e-20, 1e-3, 1.0, 1e20 })
  {
    EXPECT_TRUE(floatsHold(sphereAt(unit * Vec3(1e3, 0, 0), unit))) << unit;
    EXPECT_FALSE(floatsHold(sphereAt(unit * Vec3(1e7, 0, 0), unit))) << unit;
  }
}

TEST(FloatPoints, WhereFloatsHoldShapesStayWithinADegree)
{
  for (double distance = 1.0; distance < 1e9; distance *= 3.0)
  {
    const SurfaceMesh mesh = sphereAt(Vec3(distance, 0.3 * distance, 0.0), 1.0);
    if (floatsHold(mesh))
    {
      EXPECT_LT(std::abs(angleLostToFloats(mesh)), 1.0) << distance;
    }
    else
    {
      EXPECT_GT(distance, 1e4);
    }
  }
}

TEST(FloatPoints, PointsThatAreFloatsAlreadyAreHeldAnywhere)
{
  SurfaceMesh mesh = sphereAt(Vec3(6e5, 5e6, 700.0), 10.0);
  mesh.points = roundedToFloats(mesh.points);
  EXPECT_TRUE(floatsHold(mesh));
}

TEST(FloatPoints, AMeshWithoutSizeHasNothingToLose)
{
  EXPECT_TRUE(floatsHold({}));
  EXPECT_TRUE(floatsHold(sphereAt(Vec3(1.0, 2.0, 3.0), 0.0)));
}

} // namespace

} // namespace evolving
