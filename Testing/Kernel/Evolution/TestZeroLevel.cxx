// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/ZeroLevel.h"

#include "Evolution/EvolutionFields.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;

namespace
{

constexpr double Pi = 3.14159265358979;

} // namespace

TEST(ZeroLevel, HasTheAreaOfASphere)
{
  for (const double radius : { 0.3, 0.5, 0.8 })
  {
    const auto field = shapes::sphereField(41, 1.1, radius);
    const double reach = 2.0 * field->grid().spacing.x();
    // The mean of the areas within reach, weighted by the hat.
    const double smeared = 4.0 * Pi * (radius * radius + reach * reach / 6.0);
    EXPECT_NEAR(zeroLevelArea(*field) / smeared, 1.0, 0.005) << radius;
  }
}

TEST(ZeroLevel, HasTheAreaOfAPlaneHoweverItIsTurned)
{
  // Over a square of side 2 that no sample of the sides disturbs.
  const DistanceGrid grid = shapes::cubicGrid(41, 1.0);
  for (const double height : { 0.0, 0.017, 0.025 })
  {
    const auto flat = shapes::image(grid, [=](const Vec3& p) { return p.z() - height; });
    const double samples = 41.0 * 41.0 * grid.spacing.x() * grid.spacing.y();
    EXPECT_NEAR(zeroLevelArea(*flat), samples, 1e-5) << height;
    const auto askew =
      shapes::image(grid, [=](const Vec3& p) { return (p.z() - 0.6 * p.x() - height) / 1.16619; });
    EXPECT_NEAR(zeroLevelArea(*askew), 1.16619 * samples, 0.02 * 1.16619 * samples) << height;
  }
}

TEST(ZeroLevel, LiesInTheWorld)
{
  DistanceGrid grid = shapes::cubicGrid(61, 1.5, Vec3(3, 2, 1));
  grid.extent = { 5, 60, 0, 60, 0, 60 };
  Eigen::Matrix3d turn;
  turn << 0, -1, 0, 1, 0, 0, 0, 0, -1;
  const ImageAxes axes(turn, grid.origin);
  std::vector<float> values;
  for (int k = 0; k < 61; ++k)
  {
    for (int j = 0; j < 61; ++j)
    {
      for (int i = 5; i < 61; ++i)
      {
        values.push_back(static_cast<float>(
          std::abs((axes.pointToWorld(grid.point(i, j, k)) - grid.origin).norm() - 1.2)));
      }
    }
  }
  const ScalarImage field(grid, values, axes);
  ASSERT_FALSE(zeroLevel(field).empty());
  for (const LevelSample& sample : zeroLevel(field))
  {
    EXPECT_NEAR(std::abs((sample.point - grid.origin).norm() - 1.2), sample.distance, 1e-6);
    EXPECT_GE(sample.ijk[0], 5);
  }
}

TEST(ZeroLevel, IsNothingFarFromSamples)
{
  const auto field = shapes::image(shapes::cubicGrid(5), [](const Vec3&) { return 3.0; });
  EXPECT_EQ(zeroLevelArea(*field), 0.0);
}
