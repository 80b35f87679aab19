// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/FloodFill.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;

namespace
{

DistanceGrid unitGrid(const std::array<int, 3>& size)
{
  DistanceGrid grid;
  grid.extent = { 0, size[0] - 1, 0, size[1] - 1, 0, size[2] - 1 };
  return grid;
}

/// Clearance from, and sides of, a shell of two concentric spheres.
struct Shell
{
  Shell(const DistanceGrid& grid, double outerRadius, double innerRadius)
  {
    const Vec3 center =
      0.5 * (grid.point(0, 0, 0) + grid.point(grid.extent[1], grid.extent[3], grid.extent[5]));
    for (int k = 0; k <= grid.extent[5]; ++k)
    {
      for (int j = 0; j <= grid.extent[3]; ++j)
      {
        for (int i = 0; i <= grid.extent[1]; ++i)
        {
          const double r = (grid.point(i, j, k) - center).norm();
          radius.push_back(r);
          clearance.push_back(
            static_cast<float>(std::min(std::abs(r - outerRadius), std::abs(r - innerRadius))));
        }
      }
    }
  }
  std::vector<double> radius;
  std::vector<float> clearance;
};

} // namespace

TEST(FloodFill, FillsWhatIsNotReachedFromOutside)
{
  const DistanceGrid grid = unitGrid({ 24, 24, 24 });
  const Shell shell(grid, 9.3, 3.1);
  int asked = 0;
  FloodFillQueries queries;
  queries.isNearSurface = [&](GridIndex s)
  { return shell.clearance[static_cast<std::size_t>(s)] < 0.9F; };
  queries.isBehindSurface = [&](GridIndex s)
  {
    ++asked;
    return shell.radius[static_cast<std::size_t>(s)] < 9.3;
  };
  const std::vector<char> inside = floodFill(grid, shell.clearance, queries);
  for (std::size_t s = 0; s < inside.size(); ++s)
  {
    EXPECT_EQ(inside[s] != 0, shell.radius[s] < 9.3);
  }
  // Only samples that the flood cannot tell are asked for.
  EXPECT_LT(asked, 600);
}

TEST(FloodFill, DoesNotLeakThroughAWallThinnerThanACell)
{
  // A closed thin shell: outside and inside are only one cell apart everywhere.
  const DistanceGrid grid = unitGrid({ 24, 24, 24 });
  const Shell shell(grid, 9.3, 9.0);
  FloodFillQueries queries;
  queries.isNearSurface = [&](GridIndex s)
  { return shell.clearance[static_cast<std::size_t>(s)] < 0.9F; };
  queries.isBehindSurface = [](GridIndex) { return true; };
  const std::vector<char> inside = floodFill(grid, shell.clearance, queries);
  for (std::size_t s = 0; s < inside.size(); ++s)
  {
    if (shell.radius[s] < 8.0)
    {
      EXPECT_TRUE(inside[s]);
    }
  }
}

TEST(FloodFill, AsksForTheSideOfTheFacesWhereTheSurfaceSticksOut)
{
  const DistanceGrid grid = unitGrid({ 20, 20, 8 });
  const Shell shell(grid, 7.4, 7.4);
  FloodFillQueries queries;
  queries.isNearSurface = [&](GridIndex s)
  { return shell.clearance[static_cast<std::size_t>(s)] < 0.9F; };
  const auto isInside = [&](GridIndex s)
  { return shell.radius[static_cast<std::size_t>(s)] < 7.4; };
  queries.isBehindSurface = isInside;
  queries.isInside = isInside;
  const std::vector<char> inside = floodFill(grid, shell.clearance, queries);
  for (std::size_t s = 0; s < inside.size(); ++s)
  {
    EXPECT_EQ(inside[s] != 0, shell.radius[s] < 7.4);
  }
}
