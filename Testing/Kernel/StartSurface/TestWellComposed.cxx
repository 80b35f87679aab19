// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/WellComposed.h"

#include "Shapes/SampledOnGrid.h"

#include <gtest/gtest.h>

#include <vector>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

/// Are the cell's corners in the set joined by the cell's edges? An empty set is.
bool isConnectedAlongEdges(unsigned set)
{
  unsigned reached = set & (~set + 1U);
  for (int step = 0; step < 8; ++step)
  {
    for (unsigned b = 0; b < 8; ++b)
    {
      if ((reached >> b & 1U) != 0)
      {
        reached |= set & (1U << (b ^ 1U) | 1U << (b ^ 2U) | 1U << (b ^ 4U));
      }
    }
  }
  return reached == set;
}

/// The crossed edges of the cell's side on which coordinate `axis` is `side`.
int crossedEdgesOfSide(unsigned corners, unsigned axis, unsigned side)
{
  int crossed = 0;
  for (unsigned b = 0; b < 8; ++b)
  {
    for (unsigned other = 0; other < 3; ++other)
    {
      const unsigned end = b ^ 1U << other;
      if (other != axis && b < end && (b >> axis & 1U) == side &&
        (corners >> b & 1U) != (corners >> end & 1U))
      {
        ++crossed;
      }
    }
  }
  return crossed;
}

bool surfacePassesOnce(unsigned corners)
{
  bool once = isConnectedAlongEdges(corners) && isConnectedAlongEdges(0xffU ^ corners);
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    once = once && crossedEdgesOfSide(corners, axis, 0) <= 2;
    once = once && crossedEdgesOfSide(corners, axis, 1) <= 2;
  }
  return once;
}

std::vector<GridIndex> ambiguousCells(const InsideSamples& samples)
{
  std::vector<GridIndex> cells;
  for (int k = 0; k + 1 < samples.size(2); ++k)
  {
    for (int j = 0; j + 1 < samples.size(1); ++j)
    {
      for (int i = 0; i + 1 < samples.size(0); ++i)
      {
        if (!surfacePassesOnce(samples.cornersOfCell(samples.sample(i, j, k))))
        {
          cells.push_back(samples.sample(i, j, k));
        }
      }
    }
  }
  return cells;
}

} // namespace

TEST(WellComposed, CellsAreAmbiguousWhenTheSurfacePassesThemMoreThanOnce)
{
  int ambiguous = 0;
  for (unsigned corners = 0; corners < 256; ++corners)
  {
    EXPECT_EQ(isAmbiguousCell(corners), !surfacePassesOnce(corners)) << corners;
    ambiguous += isAmbiguousCell(corners) ? 1 : 0;
  }
  EXPECT_GT(ambiguous, 0);
  EXPECT_LT(ambiguous, 256);
}

TEST(WellComposed, NoiseLosesItsAmbiguousCellsAndOnlyTurnsInside)
{
  const DistanceGrid grid = cubicGrid(10);
  for (unsigned seed = 0; seed < 50; ++seed)
  {
    const std::vector<float> field = noise(grid, seed);
    const double isoValue = 0.02 + 0.018 * seed;
    const InsideSamples before(grid, field, isoValue);
    InsideSamples after(grid, field, isoValue);
    const GridIndex turned = makeWellComposed(after);
    EXPECT_TRUE(ambiguousCells(after).empty());
    EXPECT_EQ(turned == 0, ambiguousCells(before).empty());
    GridIndex difference = 0;
    for (GridIndex s = 0; s < before.sampleCount(); ++s)
    {
      EXPECT_TRUE(after.isInside(s) || !before.isInside(s));
      difference += after.isInside(s) != before.isInside(s) ? 1 : 0;
    }
    EXPECT_EQ(difference, turned);
    EXPECT_EQ(makeWellComposed(after), 0);
  }
}

TEST(WellComposed, TwoSamplesThatTouchAreJoinedThroughTheSmallestValue)
{
  const DistanceGrid grid = cubicGrid(4);
  for (const bool lowAlongX : { false, true })
  {
    std::vector<float> field(64, 1.0F);
    const auto at = [&](int i, int j, int k) -> float&
    { return field[static_cast<std::size_t>(grid.index(i, j, k))]; };
    at(1, 1, 1) = -1.0F;
    at(2, 2, 1) = -1.0F;
    (lowAlongX ? at(2, 1, 1) : at(1, 2, 1)) = 0.5F;
    InsideSamples samples(grid, field, 0.0);
    EXPECT_EQ(makeWellComposed(samples), 1);
    EXPECT_EQ(samples.isInside(samples.sample(2, 3, 2)), !lowAlongX);
    EXPECT_EQ(samples.isInside(samples.sample(3, 2, 2)), lowAlongX);
  }
}

TEST(WellComposed, ASmoothFieldIsLeftAlone)
{
  const DistanceGrid grid = cubicGrid(40);
  const std::vector<float> field =
    sampled(grid, [](const Vec3& p) { return torusDistance(p, 0.55, 0.25); });
  InsideSamples samples(grid, field, 0.0);
  EXPECT_EQ(makeWellComposed(samples), 0);
}
