// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/SheetFit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace evolving;

namespace
{

/// Points of a height over the half plane x > 0.
std::vector<Vec3> sheet(const std::function<double(double, double)>& height)
{
  std::vector<Vec3> points;
  for (double x = 0.5; x < 7.0; x += 1.0)
  {
    for (double y = -6.0; y < 6.5; y += 1.0)
    {
      points.emplace_back(x, y, height(x, y));
    }
  }
  return points;
}

} // namespace

TEST(SheetFit, FindsThePlaneBesideASheet)
{
  const auto plane = fitSheet(sheet([](double x, double y) { return 0.3 * x - 0.2 * y + 1.0; }),
    Vec3(-0.7, 0.4, 0.0), Vec3::UnitZ(), 3.5);
  ASSERT_TRUE(plane);
  const Vec3 normal = Vec3(-0.3, 0.2, 1.0).normalized();
  EXPECT_NEAR(plane->normal.dot(normal), 1.0, 1e-5);
  EXPECT_NEAR(plane->offset, (1.0 - 0.21 - 0.08) * normal.z(), 0.01);
  EXPECT_EQ(plane->weight, 1.0);
}

TEST(SheetFit, FollowsWhatIsRound)
{
  // A ball of radius 20; a plane through the points would be off by a fifth.
  const auto plane =
    fitSheet(sheet([](double x, double y) { return std::sqrt(400.0 - x * x - y * y) - 20.0; }),
      Vec3(0.0, 0.0, 0.3), Vec3::UnitZ(), 3.5);
  ASSERT_TRUE(plane);
  EXPECT_NEAR(plane->offset, -0.3, 0.06);
}

TEST(SheetFit, SaysNothingWithoutPoints)
{
  EXPECT_FALSE(fitSheet({}, Vec3::Zero(), Vec3::UnitZ(), 3.5));
  EXPECT_FALSE(fitSheet({ Vec3::UnitX(), Vec3::UnitY() }, Vec3::Zero(), Vec3::UnitZ(), 3.5));
  const auto far = fitSheet({ Vec3(9.0, 0.0, 0.0), Vec3(9.0, 1.0, 0.0), Vec3(10.0, 0.0, 0.0) },
    Vec3::Zero(), Vec3::UnitZ(), 3.5);
  ASSERT_TRUE(far);
  EXPECT_LT(far->weight, 0.1);
}
