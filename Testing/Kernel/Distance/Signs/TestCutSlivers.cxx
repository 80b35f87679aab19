// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/CutSlivers.h"

#include "Distance/Signs/WindingNumber.h"
#include "Mesh/Angles.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

/// The wall of a cylinder about z, two triangles as high as it for each step around.
std::vector<Triangle> cylinderWall(int around, double height)
{
  std::vector<Triangle> triangles;
  const auto point = [=](int k, double z)
  { return Vec3(std::cos(2.0 * Pi * k / around), std::sin(2.0 * Pi * k / around), z); };
  for (int k = 0; k < around; ++k)
  {
    triangles.push_back({ { point(k, 0.0), point(k + 1, 0.0), point(k + 1, height) } });
    triangles.push_back({ { point(k, 0.0), point(k + 1, height), point(k, height) } });
  }
  return triangles;
}

double longestSide(const Triangle& triangle)
{
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    longest = std::max(longest, (triangle.corners[(k + 1) % 3] - triangle.corners[k]).norm());
  }
  return longest;
}

} // namespace

TEST(CutSlivers, AreShortAndNotTooMany)
{
  const std::vector<Triangle> wall = cylinderWall(3000, 4.0);
  const std::vector<Triangle> pieces = withSliversCut(wall);
  EXPECT_GT(pieces.size(), 4 * wall.size());
  EXPECT_LT(pieces.size(), 40 * wall.size());
  double longest = 0.0;
  for (const Triangle& piece : pieces)
  {
    longest = std::max(longest, longestSide(piece));
  }
  EXPECT_LT(longest, 0.25 * 4.0);
}

TEST(CutSlivers, HaveTheAreaAndTheSolidAngleOfTheWhole)
{
  const Triangle sliver{ { Vec3(0, 0, 0), Vec3(5, 0.02, 0.01), Vec3(3, -0.01, 0.03) } };
  const std::vector<Triangle> pieces = withSliversCut({ sliver });
  ASSERT_GT(pieces.size(), 3U);
  Vec3 area = Vec3::Zero();
  for (const Triangle& piece : pieces)
  {
    area += piece.doubleAreaNormal();
  }
  EXPECT_NEAR((area - sliver.doubleAreaNormal()).norm(), 0.0, 1e-15);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 6.0);
  for (int n = 0; n < 100; ++n)
  {
    const Vec3 point(uniform(random), 0.1 * uniform(random), 0.1 * uniform(random));
    double sum = 0.0;
    for (const Triangle& piece : pieces)
    {
      sum += windingNumber(piece, point);
    }
    EXPECT_NEAR(sum, windingNumber(sliver, point), 1e-12);
  }
}

TEST(CutSlivers, LeavesOtherTrianglesAsTheyAre)
{
  const std::vector<Triangle> compact = trianglesOf(sphere(3));
  std::vector<Triangle> triangles = compact;
  triangles.push_back({ { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0) } }); // a segment
  triangles.push_back({ { Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, 0) } });
  const auto same = [](const Triangle& a, const Triangle& b) { return a.corners == b.corners; };
  for (const std::vector<Triangle>& all : { compact, triangles, std::vector<Triangle>() })
  {
    const std::vector<Triangle> pieces = withSliversCut(all);
    EXPECT_TRUE(std::equal(pieces.begin(), pieces.end(), all.begin(), all.end(), same));
  }
}

TEST(CutSlivers, GiveTheWindingNumberOfTheWhole)
{
  const std::vector<Triangle> wall = cylinderWall(500, 3.0);
  const WindingNumber winding(wall);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-2.0, 4.0);
  for (int n = 0; n < 300; ++n)
  {
    const Vec3 point(0.5 * uniform(random), 0.5 * uniform(random), uniform(random));
    double sum = 0.0;
    for (const Triangle& triangle : wall)
    {
      sum += windingNumber(triangle, point);
    }
    EXPECT_NEAR(winding.at(point), sum, 0.5 * WindingNumber::Tolerance);
  }
}
