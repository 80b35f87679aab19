// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/ClosestPoint/FramedTriangle.h"

#include <gtest/gtest.h>

using namespace evolving;

namespace
{

Vec3 vector(const float stored[3])
{
  return { stored[0], stored[1], stored[2] };
}

/// A point of the plane in space.
Vec3 inSpace(const FramedTriangle& framed, double x, double y)
{
  return Vec3(framed.anchor[0], framed.anchor[1], framed.anchor[2]) + x * vector(framed.along) +
    y * vector(framed.beside);
}

/// Is there a corner at a point?
bool isCorner(const Triangle& triangle, const Vec3& point)
{
  for (const Vec3& corner : triangle.corners)
  {
    if ((corner - point).norm() < 1e-6 * (1.0 + corner.norm()))
    {
      return true;
    }
  }
  return false;
}

} // namespace

TEST(FramedTriangle, HasItsCornersWhereTheTriangleHas)
{
  const Triangle triangle{ { Vec3(1, 2, 3), Vec3(1.5, 2, 2.5), Vec3(0, 4, 3.5) } };
  const FramedTriangle framed(triangle, 7);
  EXPECT_EQ(framed.number, 7);
  EXPECT_TRUE(isCorner(triangle, inSpace(framed, 0.0, 0.0)));
  EXPECT_TRUE(isCorner(triangle, inSpace(framed, framed.length, 0.0)));
  const FramedTriangle::Edge& edge = framed.second;
  const double x = framed.length + edge.length * edge.directionX;
  EXPECT_NEAR(edge.length * edge.directionY, framed.height, 1e-6);
  EXPECT_TRUE(isCorner(triangle, inSpace(framed, x, framed.height)));
  EXPECT_NEAR(framed.third.length, std::hypot(x, framed.height), 1e-6);
}

TEST(FramedTriangle, HasARightHandedFrameOfUnitVectorsAndBeginsWithTheLongestEdge)
{
  const Triangle triangle{ { Vec3(0, 0, 0), Vec3(0.1, 0, 0.2), Vec3(-3, 1, 2) } };
  const FramedTriangle framed(triangle, 0);
  EXPECT_NEAR(
    (vector(framed.along).cross(vector(framed.beside)) - vector(framed.normal)).norm(), 0.0, 1e-6);
  EXPECT_NEAR(vector(framed.along).norm(), 1.0, 1e-6);
  EXPECT_NEAR(vector(framed.beside).norm(), 1.0, 1e-6);
  EXPECT_GE(framed.length, framed.second.length);
  EXPECT_GE(framed.length, framed.third.length);
}

TEST(FramedTriangle, OfASegmentOrAPointHasNoInside)
{
  const Vec3 point(1, 2, 3);
  const Triangle segment{ { point, Vec3(2, 2, 3), Vec3(4, 2, 3) } };
  for (const Triangle& triangle : { segment, Triangle{ { point, point, point } } })
  {
    const FramedTriangle framed(triangle, 0);
    EXPECT_EQ(framed.height, 0.0F);
    // The longest edge runs one way and another the other way: nothing is on the left of both.
    EXPECT_EQ(framed.second.directionX, -1.0F);
    EXPECT_TRUE(vector(framed.normal).allFinite());
    EXPECT_NEAR(vector(framed.normal).norm(), 1.0, 1e-6);
  }
  EXPECT_NEAR(FramedTriangle(segment, 0).length, 3.0, 1e-6);
}

TEST(FramedTriangle, SmallerThanSquaresAreExactHasAFrameOfUnitVectors)
{
  for (const double length : { 1e-150, 1e-160, 3e-162, 1e-170, 1e-310 })
  {
    const Vec3 tip(0.6 * length, 0.8 * length, 0.0);
    const Triangle segment{ { Vec3::Zero(), tip, tip } };
    const Triangle sliver{ { Vec3::Zero(), Vec3(1, 0, 0), tip } };
    for (const Triangle& triangle : { segment, sliver })
    {
      const FramedTriangle framed(triangle, 0);
      EXPECT_NEAR(vector(framed.along).norm(), 1.0, 1e-6) << length;
      EXPECT_NEAR(vector(framed.normal).norm(), 1.0, 1e-6) << length;
      for (const FramedTriangle::Edge& edge : { framed.second, framed.third })
      {
        EXPECT_NEAR(std::hypot(edge.directionX, edge.directionY), 1.0, 1e-6) << length;
      }
    }
  }
}
