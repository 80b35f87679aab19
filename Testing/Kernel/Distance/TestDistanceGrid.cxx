// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/DistanceGrid.h"

#include "Errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace evolving;

TEST(DistanceGrid, NumbersSamplesWithXFastest)
{
  DistanceGrid grid;
  grid.extent = { 2, 4, -1, 0, 5, 8 };
  EXPECT_EQ(grid.sampleCount(), 3 * 2 * 4);
  GridIndex expected = 0;
  for (int k = 5; k <= 8; ++k)
  {
    for (int j = -1; j <= 0; ++j)
    {
      for (int i = 2; i <= 4; ++i)
      {
        EXPECT_EQ(grid.index(i, j, k), expected++);
      }
    }
  }
}

TEST(DistanceGrid, CountsMoreThanTwoToThe31Samples)
{
  DistanceGrid grid;
  grid.extent = { 0, 2047, 0, 2047, 0, 2047 };
  EXPECT_EQ(grid.sampleCount(), GridIndex(1) << 33);
  EXPECT_EQ(grid.index(2047, 2047, 2047), (GridIndex(1) << 33) - 1);
}

TEST(DistanceGrid, EmptyExtentHasNoSamples)
{
  EXPECT_EQ(DistanceGrid().sampleCount(), 0);
}

TEST(DistanceGrid, PartKeepsThePositionsOfItsSamples)
{
  const DistanceGrid grid = gridAround(Box(Vec3(-1, 2, 3), Vec3(4, 5, 6)), { 20, 10, 12 }, 0.1);
  const DistanceGrid part = grid.part({ 5, 9, 2, 4, 7, 11 });
  EXPECT_EQ(part.sampleCount(), 5 * 3 * 5);
  EXPECT_EQ(part.point(6, 3, 8), grid.point(6, 3, 8));
}

TEST(GridAround, HasCubesAndContainsThePaddedBox)
{
  const Box box(Vec3(-1, 2, 3), Vec3(4, 5, 3.5));
  const DistanceGrid grid = gridAround(box, { 30, 40, 50 }, 0.2);
  EXPECT_TRUE(grid.isCubic());
  EXPECT_EQ(grid.spacing.x(), grid.spacing.z());
  const Vec3 low = grid.point(0, 0, 0);
  const Vec3 high = grid.point(29, 39, 49);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_LE(low[axis], box.min()[axis] - 0.2 * 5.0 + 1e-12);
    EXPECT_GE(high[axis], box.max()[axis] + 0.2 * 5.0 - 1e-12);
  }
  EXPECT_LT((0.5 * (low + high) - box.center()).norm(), 1e-12);
  // One axis is filled: cells are no larger than they have to be.
  const Vec3 slack = (high - low) - (box.sizes() + Vec3::Constant(2.0));
  EXPECT_NEAR(slack.minCoeff(), 0.0, 1e-12);
}

TEST(GridAround, SamplesASliceThroughTheMiddle)
{
  const Box box(Vec3(0, 0, 0), Vec3(2, 4, 6));
  const DistanceGrid grid = gridAround(box, { 11, 1, 11 }, 0.0);
  EXPECT_EQ(grid.point(0, 0, 0).y(), 2.0);
  EXPECT_TRUE(grid.isCubic());
  EXPECT_GT(grid.spacing.y(), 0.0);
}

TEST(GridAround, GivesPositiveSpacingToBoxesWithoutExtent)
{
  for (const Box& box : { Box(), Box(Vec3(1, 2, 3), Vec3(1, 2, 3)) })
  {
    const DistanceGrid grid = gridAround(box, { 4, 4, 4 }, 0.1);
    EXPECT_TRUE(grid.origin.allFinite());
    EXPECT_GT(grid.spacing.minCoeff(), 0.0);
  }
  const DistanceGrid one = gridAround(Box(Vec3(0, 0, 0), Vec3(1, 1, 1)), { 1, 1, 1 }, 0.1);
  EXPECT_EQ(one.point(0, 0, 0), Vec3(0.5, 0.5, 0.5));
  EXPECT_GT(one.spacing.minCoeff(), 0.0);
}

TEST(GridAround, RefusesEmptyDimensions)
{
  EXPECT_THROW(gridAround(Box(Vec3(0, 0, 0), Vec3(1, 1, 1)), { 4, 0, 4 }, 0.1), InputError);
}

TEST(GridAround, RefusesAPaddingThatIsNoNumber)
{
  const Box box(Vec3(0, 0, 0), Vec3(1, 1, 1));
  for (const double padding : { std::nan(""), HUGE_VAL, -0.1 })
  {
    EXPECT_THROW(gridAround(box, { 4, 4, 4 }, padding), InputError);
  }
}

TEST(GridOver, HasTheBoxsCornersWhateverTheCells)
{
  const Box box(Vec3(-1, 2, 3), Vec3(4, 5, 6));
  const DistanceGrid grid = gridOver(box, { 6, 4, 31 });
  EXPECT_LT((grid.point(0, 0, 0) - box.min()).norm(), 1e-14);
  EXPECT_LT((grid.point(5, 3, 30) - box.max()).norm(), 1e-14);
  EXPECT_FALSE(grid.isCubic());
  EXPECT_TRUE(gridOver(Box(Vec3(0, 0, 0), Vec3(1, 2, 3)), { 11, 21, 31 }).isCubic());
  EXPECT_TRUE(gridOver(Box(Vec3(0, 0, 0), Vec3(1, 2, 7)), { 11, 21, 1 }).isCubic());
}

TEST(GridOver, RefusesABoxWithoutExtent)
{
  EXPECT_THROW(gridOver(Box(Vec3(0, 0, 0), Vec3(1, 0, 1)), { 4, 4, 4 }), InputError);
  EXPECT_THROW(gridOver(Box(Vec3(0, 0, 0), Vec3(1, -1, 1)), { 4, 4, 4 }), InputError);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(gridOver(Box(Vec3(0, 0, 0), Vec3(1, nan, 1)), { 4, 4, 4 }), InputError);
}
