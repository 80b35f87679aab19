// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/DistanceGradient.h"

#include <gtest/gtest.h>

using namespace evolving;

TEST(DistanceGradient, OfALinearFunctionIsItsDirection)
{
  DistanceGrid grid;
  grid.spacing = Vec3(0.5, 1.0, 2.0);
  grid.extent = { 3, 8, -2, 2, 0, 3 };
  const Vec3 slope(1.0, -2.0, 2.0);
  std::vector<float> values;
  for (int k = 0; k <= 3; ++k)
  {
    for (int j = -2; j <= 2; ++j)
    {
      for (int i = 3; i <= 8; ++i)
      {
        values.push_back(static_cast<float>(slope.dot(grid.point(i, j, k))));
      }
    }
  }
  const std::vector<float> gradient = normalizedDifferences(grid, values);
  ASSERT_EQ(gradient.size(), 3 * values.size());
  for (std::size_t s = 0; s < values.size(); ++s)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(gradient[3 * s + axis], slope[static_cast<int>(axis)] / 3.0, 1e-6);
    }
  }
}

TEST(DistanceGradient, IsZeroWhereNothingChangesAndAlongAxesOfOneSample)
{
  DistanceGrid grid;
  grid.extent = { 0, 2, 0, 0, 0, 0 };
  EXPECT_EQ(normalizedDifferences(grid, { 1.0F, 1.0F, 1.0F }), std::vector<float>(9, 0.0F));
  const std::vector<float> rising = normalizedDifferences(grid, { 1.0F, 2.0F, 3.0F });
  EXPECT_EQ(rising, (std::vector<float>{ 1, 0, 0, 1, 0, 0, 1, 0, 0 }));
}
