// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Trees/Ray.h"

#include <gtest/gtest.h>

#include <vector>

using namespace evolving;

namespace
{

const Triangle Right{ { Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0) } };

} // namespace

TEST(Ray, HitsWhereItCrosses)
{
  const Ray ray(Vec3(1, 1, -3), Vec3(0, 0, 2));
  ASSERT_TRUE(ray.hit(Right).has_value());
  EXPECT_DOUBLE_EQ(*ray.hit(Right), 1.5);
  EXPECT_FALSE(Ray(Vec3(1, 1, 3), Vec3(0, 0, 2)).hit(Right).has_value());
  EXPECT_FALSE(Ray(Vec3(3, 3, -3), Vec3(0, 0, 2)).hit(Right).has_value());
  EXPECT_TRUE(Ray(Vec3(5, 1, 1), Vec3(-4, 0, -1)).hit(Right).has_value());
}

TEST(Ray, TellsFromWhichSideItCrosses)
{
  for (const Vec3& direction : { Vec3(0, 0, 1), Vec3(2, 0.3, 0.1), Vec3(-0.2, -3, 0.1) })
  {
    for (const double sign : { 1.0, -1.0 })
    {
      const Ray ray(Vec3(1, 1, 0) - sign * direction, sign * direction);
      ASSERT_TRUE(ray.crossing(Right).has_value());
      EXPECT_NEAR(ray.crossing(Right)->parameter, 1.0, 1e-12);
      EXPECT_EQ(ray.crossing(Right)->isFromBehind, sign > 0.0);
      const Triangle turned{ { Right.corners[0], Right.corners[2], Right.corners[1] } };
      EXPECT_EQ(ray.crossing(turned)->isFromBehind, sign < 0.0);
    }
  }
}

TEST(Ray, CrossesExactlyOneTriangleOfAFanAtItsVertexAndEdges)
{
  // Rays straight through vertices and edges of a flat grid of triangles.
  std::vector<Triangle> triangles;
  for (int i = -2; i < 2; ++i)
  {
    for (int j = -2; j < 2; ++j)
    {
      const Vec3 a(i, j, 0);
      const Vec3 b(i + 1, j, 0);
      const Vec3 c(i + 1, j + 1, 0);
      const Vec3 d(i, j + 1, 0);
      triangles.push_back({ { a, b, c } });
      triangles.push_back({ { a, c, d } });
    }
  }
  for (const Vec3& target : { Vec3(0, 0, 0), Vec3(0.5, 0, 0), Vec3(0.5, 0.5, 0), Vec3(1, 0.25, 0) })
  {
    for (const Vec3& direction : { Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(0.5, 0.25, 1) })
    {
      const Ray ray(target - direction, direction);
      int hits = 0;
      for (const Triangle& triangle : triangles)
      {
        hits += ray.hit(triangle).has_value() ? 1 : 0;
      }
      EXPECT_EQ(hits % 2, 1) << target.transpose() << " along " << direction.transpose();
    }
  }
}

TEST(Ray, MeetsBoxesBehindItOnlyWhenItStartsInside)
{
  const Box unit(Vec3(0, 0, 0), Vec3(1, 1, 1));
  EXPECT_TRUE(Ray(Vec3(0.5, 0.5, 0.5), Vec3(0, 0, 1)).meets(unit));
  EXPECT_TRUE(Ray(Vec3(0.5, 0.5, -5), Vec3(0, 0, 1)).meets(unit));
  EXPECT_FALSE(Ray(Vec3(0.5, 0.5, 5), Vec3(0, 0, 1)).meets(unit));
  EXPECT_FALSE(Ray(Vec3(1.5, 0.5, -5), Vec3(0, 0, 1)).meets(unit));
  EXPECT_TRUE(Ray(Vec3(1, 1, -5), Vec3(0, 0, 1)).meets(unit));
}
