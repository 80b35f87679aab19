// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Shapes/Draws.h"
#include "ShrinkWrap/TightGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

namespace
{

using namespace evolving;

TEST(TightGrid, CoversTheBoxAndItsRoomWithThreeCellsToSpare)
{
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> length(0.0, 10.0);
  std::uniform_int_distribution<int> count(8, 90);
  for (int i = 0; i < 500; ++i)
  {
    const Vec3 low(length(generator), -length(generator), length(generator));
    const Box box(low, low + shapes::drawnVector(length, generator));
    const std::array<int, 3> dimensions = { count(generator), count(generator), count(generator) };
    const double room = length(generator) / 10.0;
    const DistanceGrid grid = tightGrid(box, dimensions, room);
    const double cell = grid.spacing.x();
    ASSERT_TRUE(grid.isCubic());
    int asMany = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto a = static_cast<std::size_t>(axis);
      const double below = box.min()[axis] - room - grid.origin[axis];
      const double end = grid.origin[axis] + (grid.dimension(axis) - 1) * cell;
      const double above = end - box.max()[axis] - room;
      ASSERT_NEAR(below, above, 1e-9);
      ASSERT_GT(below, (3.0 - 1e-9) * cell);
      ASSERT_LT(below, 3.5 * cell); // tight: less than a cell of both together is wasted
      ASSERT_LE(grid.dimension(axis), dimensions[a]);
      asMany += grid.dimension(axis) == dimensions[a] ? 1 : 0;
    }
    ASSERT_GE(asMany, 1);
  }
}

TEST(TightGrid, OfAFlatOrSmallBoxIsNoLessThanItsMargins)
{
  const Box flat(Vec3(-1.0, -1.0, 0.0), Vec3(1.0, 1.0, 0.0));
  const DistanceGrid grid = tightGrid(flat, { 27, 27, 27 }, 0.0);
  EXPECT_EQ(grid.dimension(0), 27);
  EXPECT_EQ(grid.dimension(2), 7); // three cells on either side
  EXPECT_NEAR(grid.spacing.x(), 0.1, 1e-15);
  // Fewer samples than the margins need are taken for one cell of the box.
  EXPECT_EQ(tightGrid(flat, { 2, 2, 2 }, 0.0).dimension(0), 8);
}

TEST(TightGrid, RoomForCellsIsTheInverse)
{
  std::mt19937 generator(6);
  std::uniform_real_distribution<double> length(0.1, 10.0);
  std::uniform_int_distribution<int> count(9, 90);
  for (int i = 0; i < 200; ++i)
  {
    const Box box(Vec3::Zero(), shapes::drawnVector(length, generator));
    const std::array<int, 3> dimensions = { count(generator), count(generator), count(generator) };
    const double room = length(generator);
    const double cell = tightGrid(box, dimensions, room).spacing.x();
    ASSERT_NEAR(roomForCells(box, dimensions, cell), room, 1e-9 * room);
    const double tight = tightGrid(box, dimensions, 0.0).spacing.x();
    ASSERT_LT(roomForCells(box, dimensions, 0.9 * tight), 0.0);
  }
}

} // namespace
