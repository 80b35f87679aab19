// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/TrianglePairs.h"

#include "TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace evolving
{

namespace
{

using IntegerVector = Eigen::Matrix<std::int64_t, 3, 1>;
using IntegerHull = std::vector<IntegerVector>;

bool separates(const IntegerVector& axis, const IntegerHull& p, const IntegerHull& q)
{
  std::int64_t extents[2][2];
  for (int i = 0; i < 2; ++i)
  {
    const IntegerHull& hull = i == 0 ? p : q;
    extents[i][0] = extents[i][1] = axis.dot(hull[0]);
    for (const IntegerVector& point : hull)
    {
      extents[i][0] = std::min(extents[i][0], axis.dot(point));
      extents[i][1] = std::max(extents[i][1], axis.dot(point));
    }
  }
  return extents[0][1] < extents[1][0] || extents[1][1] < extents[0][0];
}

/// By the separating axes of flat convex sets with area, in integers: slow and exact.
bool hullsMeet(const IntegerHull& p, const IntegerHull& q)
{
  std::vector<IntegerVector> edges;
  for (const IntegerHull* hull : { &p, &q })
  {
    for (std::size_t i = 0; i < hull->size(); ++i)
    {
      for (std::size_t j = i + 1; j < hull->size(); ++j)
      {
        edges.push_back((*hull)[j] - (*hull)[i]);
      }
    }
  }
  for (const IntegerVector& e : edges)
  {
    for (const IntegerVector& f : edges)
    {
      const IntegerVector normal = e.cross(f);
      if (separates(normal, p, q) || separates(normal.cross(e), p, q))
      {
        return false;
      }
    }
  }
  return true;
}

struct IntegerTriangles
{
  std::vector<IntegerVector> points;
  std::vector<TriangleVertices> triangles;

  IntegerHull hull(const TriangleVertices& triangle) const
  {
    IntegerHull corners;
    for (const Index vertex : triangle)
    {
      corners.push_back(this->points[static_cast<std::size_t>(vertex)]);
    }
    return corners;
  }
};

/// What is left of a triangle when a thousandth is cut off at its corner v; all times a thousand.
IntegerHull withoutCorner(const IntegerHull& triangle, const IntegerVector& v)
{
  IntegerHull rest;
  for (const IntegerVector& corner : triangle)
  {
    if (corner != v)
    {
      rest.push_back(999 * v + corner);
      rest.push_back(1000 * corner);
    }
  }
  return rest;
}

bool referenceAnswer(
  const IntegerTriangles& mesh, const TriangleVertices& first, const TriangleVertices& second)
{
  std::vector<Index> shared;
  for (const Index vertex : first)
  {
    if (std::count(second.begin(), second.end(), vertex) > 0)
    {
      shared.push_back(vertex);
    }
  }
  const IntegerHull p = mesh.hull(first);
  const IntegerHull q = mesh.hull(second);
  if (shared.size() == 1)
  {
    const IntegerVector& v = mesh.points[static_cast<std::size_t>(shared[0])];
    return hullsMeet(withoutCorner(p, v), withoutCorner(q, v));
  }
  if (shared.size() == 2)
  {
    const auto apex = [&](const TriangleVertices& triangle)
    {
      const auto other = std::find_if(triangle.begin(), triangle.end(),
        [&](Index vertex) { return vertex != shared[0] && vertex != shared[1]; });
      return mesh.points[static_cast<std::size_t>(*other)];
    };
    const IntegerVector& a = mesh.points[static_cast<std::size_t>(shared[0])];
    const IntegerVector edge = mesh.points[static_cast<std::size_t>(shared[1])] - a;
    const IntegerVector n = edge.cross(apex(first) - a);
    const IntegerVector m = edge.cross(apex(second) - a);
    return n.cross(m).isZero() && n.dot(m) > 0;
  }
  return shared.size() == 3 || hullsMeet(p, q);
}

/// Few points on a small lattice: touching, coplanar and equal points abound.
IntegerTriangles randomLatticeTriangles(std::mt19937& generator)
{
  std::uniform_int_distribution<int> coordinate(0, 4);
  std::uniform_int_distribution<Index> vertex(0, 11);
  IntegerTriangles mesh;
  for (int i = 0; i < 12; ++i)
  {
    mesh.points.emplace_back(coordinate(generator), coordinate(generator), coordinate(generator));
  }
  while (mesh.triangles.size() < 24)
  {
    const TriangleVertices triangle{ vertex(generator), vertex(generator), vertex(generator) };
    const IntegerHull hull = mesh.hull(triangle);
    if (!(hull[1] - hull[0]).cross(hull[2] - hull[0]).isZero())
    {
      mesh.triangles.push_back(triangle);
    }
  }
  return mesh;
}

std::vector<Vec3> asDoubles(const IntegerTriangles& mesh, const Eigen::Matrix3d& map, double offset)
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
  for (int trial = 0; trial < 100; ++trial)
  {
    const IntegerTriangles mesh = randomLatticeTriangles(generator);
    const std::vector<Vec3> plain = asDoubles(mesh, Eigen::Matrix3d::Identity(), 0.0);
    const std::vector<Vec3> distant = asDoubles(mesh, Eigen::Matrix3d::Identity(), 1e15);
    const std::vector<Vec3> skew = asDoubles(mesh, randomIntegerMap(generator), 0.0);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
      for (std::size_t j = i + 1; j < mesh.triangles.size(); ++j)
      {
        const TriangleVertices& t = mesh.triangles[i];
        const TriangleVertices& s = mesh.triangles[j];
        const bool expected = referenceAnswer(mesh, t, s);
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
