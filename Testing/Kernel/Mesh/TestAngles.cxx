// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/Angles.h"
#include "Mesh/Orthogonal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace evolving
{

namespace
{

/// One in each octant and along each axis.
std::vector<Vec3> someVectors()
{
  std::vector<Vec3> vectors;
  for (const double x : { -2.0, 0.0, 1.0 })
  {
    for (const double y : { -0.5, 0.0, 3.0 })
    {
      for (const double z : { -1.0, 0.0, 0.25 })
      {
        vectors.emplace_back(x, y, z);
      }
    }
  }
  return vectors;
}

TEST(Angles, AVanishingVectorHasNoAngleWithAny)
{
  for (const Vec3& v : someVectors())
  {
    EXPECT_EQ(angleBetween(Vec3::Zero(), v), 0.0) << v.transpose();
    EXPECT_EQ(angleBetween(v, Vec3::Zero()), 0.0) << v.transpose();
    EXPECT_EQ(cotangentBetween(v, Vec3::Zero()), HUGE_VAL) << v.transpose();
  }
}

TEST(Angles, CotangentsBelongToTheAngles)
{
  for (const double degrees : { 1e-6, 1.0, 45.0, 90.0, 120.0, 179.999 })
  {
    const double angle = degrees * RadiansPerDegree;
    const Vec3 a(0, 2, 0);
    const Vec3 b(0, std::cos(angle), std::sin(angle));
    EXPECT_NEAR(angleBetween(a, b), angle, 1e-15 + 1e-15 * angle);
    EXPECT_NEAR(cotangentBetween(a, b) * std::sin(angle), std::cos(angle), 1e-12);
  }
  EXPECT_EQ(cotangentBetween(Vec3(1, 0, 0), Vec3(3, 0, 0)), HUGE_VAL);
  EXPECT_EQ(cotangentBetween(Vec3(1, 0, 0), Vec3(-3, 0, 0)), -HUGE_VAL);
}

TEST(Angles, OrthogonalVectorsBeginARightHandedBasis)
{
  EXPECT_TRUE(orthogonalTo(Vec3::Zero()).isZero(0.0));
  for (const Vec3& v : someVectors())
  {
    const Vec3 first = orthogonalTo(v);
    EXPECT_NEAR(first.dot(v), 0.0, 1e-15 * v.squaredNorm());
    EXPECT_GE(first.norm(), 0.8 * v.norm());
    EXPECT_NEAR(first.cross(Vec3(v.cross(first))).dot(v), v.squaredNorm() * first.squaredNorm(),
      1e-12 * (1.0 + v.squaredNorm() * first.squaredNorm()));
  }
}

} // namespace

} // namespace evolving
