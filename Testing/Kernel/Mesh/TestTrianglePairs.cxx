// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/TrianglePairs.h"

#include "LatticeTriangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace evolving
{

namespace
{

std::vector<Vec3> asDoubles(const LatticeTriangles& mesh, const Eigen::Matrix3d& map, double offset)
{
  std::vector<Vec3> points;
  for (const IntegerVector& point : mesh.points)
  {
    points.push_back(map * point.cast<double>() + Vec3::Constant(offset));
  }
  return points;
}

/// Whole numbers up to 2^48: skew planes, in which rounding decides nothing rightly.
Eigen::Matrix3d randomIntegerMap(std::mt19937& generator)
{
  std::uniform_real_distribution<double> entry(-std::pow(2.0, 48), std::pow(2.0, 48));
  return Eigen::Matrix3d::NullaryExpr([&] { return std::round(entry(generator)); });
}

TEST(TrianglePairs, AgreeWithIntegerArithmeticOnLatticesUnderAnyAffineMap)
{
  std::mt19937 generator(47);
  int counts[4][2] = {};
  for (int trial = 0; trial < 60; ++trial)
  {
    const LatticeTriangles mesh = randomLatticeTriangles(generator);
    const std::vector<Vec3> plain = asDoubles(mesh, Eigen::Matrix3d::Identity(), 0.0);
    const std::vector<Vec3> distant = asDoubles(mesh, Eigen::Matrix3d::Identity(), 1e15);
    const std::vector<Vec3> skew = asDoubles(mesh, randomIntegerMap(generator), 0.0);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
      for (std::size_t j = i + 1; j < mesh.triangles.size(); ++j)
      {
        const TriangleVertices& t = mesh.triangles[i];
        const TriangleVertices& s = mesh.triangles[j];
        const bool expected = latticeTrianglesIntersect(mesh, t, s);
        ASSERT_EQ(intersectBeyondShared(plain, t, s), expected) << "trial " << trial;
        ASSERT_EQ(intersectBeyondShared(plain, s, t), expected) << "trial " << trial;
        ASSERT_EQ(intersectBeyondShared(distant, t, s), expected) << "trial " << trial;
        ASSERT_EQ(intersectBeyondShared(skew, t, s), expected) << "trial " << trial;
        const auto shared = std::count_if(
          t.begin(), t.end(), [&](Index v) { return std::count(s.begin(), s.end(), v) > 0; });
        ++counts[shared][expected ? 1 : 0];
      }
    }
  }
  for (int shared = 0; shared < 3; ++shared)
  {
    EXPECT_GT(counts[shared][0], 50) << shared << " shared vertices, apart";
    EXPECT_GT(counts[shared][1], 50) << shared << " shared vertices, intersecting";
  }
  EXPECT_GT(counts[3][1], 5);
  EXPECT_EQ(counts[3][0], 0);
}

TEST(TrianglePairs, TheLastBitDecidesWhetherATipTouches)
{
  // Vertices 0, 1, 2 span the plane z = x / 3; the tip 3 moves by one bit.
  std::vector<Vec3> points{ { 0, -1, 0 }, { 3, -1, 1 }, { 0, 2, 0 }, { 0.75, 0.25, 0.25 },
    { 0.75, 0.25, 2 }, { 0.5, 0.5, 2 } };
  EXPECT_TRUE(intersectBeyondShared(points, { 0, 1, 2 }, { 3, 4, 5 }));
  points[3].z() = std::nextafter(0.25, 1.0);
  EXPECT_FALSE(intersectBeyondShared(points, { 0, 1, 2 }, { 3, 4, 5 }));
  points[3].z() = std::nextafter(0.25, 0.0);
  EXPECT_TRUE(intersectBeyondShared(points, { 0, 1, 2 }, { 3, 4, 5 }));
}

TEST(TrianglePairs, ASharedVertexIsNoIntersectionButPiercingIs)
{
  const std::vector<Vec3> points{ { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 3 }, { 1, 1, 3 },
    { 0.5, 0.5, -1 }, { -1, -1, 0 }, { -2, -1, 0 }, { 1, 1, 0 } };
  EXPECT_FALSE(intersectBeyondShared(points, { 0, 1, 2 }, { 0, 3, 4 })) << "upright on its vertex";
  EXPECT_TRUE(intersectBeyondShared(points, { 0, 1, 2 }, { 0, 4, 5 })) << "through the inside";
  EXPECT_FALSE(intersectBeyondShared(points, { 0, 1, 2 }, { 0, 6, 7 })) << "coplanar, behind";
  EXPECT_TRUE(intersectBeyondShared(points, { 0, 1, 2 }, { 0, 3, 8 })) << "along a line inside";
  EXPECT_TRUE(intersectBeyondShared(points, { 0, 1, 2 }, { 0, 8, 7 })) << "coplanar, over it";
}

TEST(TrianglePairs, ASharedEdgeIsAnIntersectionOnlyWhenFoldedFlat)
{
  std::vector<Vec3> points{ { 0, 0, 0 }, { 1, 2, 3 }, { 1, 0, 0 }, { 0, 0, 0 } };
  const Vec3 inPlane = 0.25 * points[1] + 0.5 * points[2];
  points[3] = inPlane;
  EXPECT_TRUE(intersectBeyondShared(points, { 0, 1, 2 }, { 1, 0, 3 }));
  points[3] = -inPlane;
  EXPECT_FALSE(intersectBeyondShared(points, { 0, 1, 2 }, { 1, 0, 3 })) << "unfolded";
  points[3] = inPlane + Vec3(0, 0, 1e-15);
  EXPECT_FALSE(intersectBeyondShared(points, { 0, 1, 2 }, { 1, 0, 3 })) << "not quite flat";
}

TEST(TrianglePairs, EqualTrianglesAlwaysIntersect)
{
  const std::vector<Vec3> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 0 }, { 1, 0, 0 },
    { 0, 1, 0 } };
  EXPECT_TRUE(intersectBeyondShared(points, { 0, 1, 2 }, { 2, 1, 0 }));
  EXPECT_TRUE(intersectBeyondShared(points, { 0, 1, 2 }, { 3, 4, 5 })) << "by other numbers";
}

TEST(TrianglePairs, AreaIsDecidedExactly)
{
  std::vector<Vec3> points{ { 0.1, 0.1, 0.1 }, { 0.2, 0.2, 0.2 }, { 0.4, 0.4, 0.4 } };
  EXPECT_FALSE(hasArea(points, { 0, 1, 2 }));
  points[2].x() = std::nextafter(0.4, 1.0);
  EXPECT_TRUE(hasArea(points, { 0, 1, 2 }));
  EXPECT_FALSE(hasArea(points, { 0, 1, 1 }));
}

} // namespace

} // namespace evolving
