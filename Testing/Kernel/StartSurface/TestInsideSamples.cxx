// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/InsideSamples.h"

#include "Errors.h"
#include "Shapes/SampledOnGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace evolving;
using namespace evolving::shapes;

TEST(InsideSamples, AreTheSamplesBelowTheIsoValueWithinAnOutsideLayer)
{
  DistanceGrid grid = cubicGrid(2);
  grid.extent = { 5, 6, -3, -2, 0, 2 };
  std::vector<float> field;
  for (int n = 0; n < 12; ++n)
  {
    field.push_back(static_cast<float>(n));
  }
  const InsideSamples samples(grid, field, 4.0);
  EXPECT_EQ(samples.size(0), 4);
  EXPECT_EQ(samples.size(1), 4);
  EXPECT_EQ(samples.size(2), 5);
  int inside = 0;
  for (GridIndex sample = 0; sample < samples.sampleCount(); ++sample)
  {
    inside += samples.isInside(sample) ? 1 : 0;
  }
  EXPECT_EQ(inside, 4);
  EXPECT_TRUE(samples.isInside(samples.sample(2, 2, 1)));
  EXPECT_EQ(samples.valueAboveIso(samples.sample(2, 2, 1)), -1.0);
  EXPECT_EQ(samples.valueAboveIso(samples.sample(1, 2, 3)), 6.0);
  EXPECT_EQ(samples.valueAboveIso(0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(
    samples.valueAboveIso(samples.sample(3, 1, 1)), std::numeric_limits<double>::infinity());
  EXPECT_EQ(samples.cornersOfCell(samples.sample(0, 0, 0)), 0x80U);
  EXPECT_EQ(samples.cornersOfCell(samples.sample(1, 1, 1)), 0x0fU);
}

TEST(InsideSamples, RefuseFieldsThatDoNotFit)
{
  const DistanceGrid grid = cubicGrid(3);
  EXPECT_THROW(InsideSamples(grid, std::vector<float>(26), 0.0), InputError);
  EXPECT_THROW(InsideSamples(DistanceGrid(), std::vector<float>(), 0.0), InputError);
  std::vector<float> field(27, 1.0F);
  field[13] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(InsideSamples(grid, field, 0.0), InputError);
  field[13] = std::numeric_limits<float>::infinity();
  EXPECT_THROW(InsideSamples(grid, field, 0.0), InputError);
}

TEST(FillCavities, TurnsExactlyWhatIsShutOffFromTheBorder)
{
  // A shell with a ball in its cavity, and a bowl whose hollow is open.
  const DistanceGrid grid = cubicGrid(31);
  const auto shellAndBall = [](const Vec3& p)
  { return std::min(std::abs(p.norm() - 0.7) - 0.1, p.norm() - 0.2); };
  const auto solid = [](const Vec3& p) { return p.norm() - 0.8; };
  const auto bowl = [](const Vec3& p)
  { return std::max(std::abs(p.norm() - 0.7) - 0.1, p.z() - 0.3); };

  const std::vector<float> shellField = sampled(grid, shellAndBall);
  const std::vector<float> solidField = sampled(grid, solid);
  InsideSamples filled(grid, shellField, 0.0);
  const InsideSamples expected(grid, solidField, 0.0);
  EXPECT_GT(fillCavities(filled), 0);
  for (GridIndex sample = 0; sample < filled.sampleCount(); ++sample)
  {
    ASSERT_EQ(filled.isInside(sample), expected.isInside(sample));
  }

  const std::vector<float> bowlField = sampled(grid, bowl);
  InsideSamples open(grid, bowlField, 0.0);
  EXPECT_EQ(fillCavities(open), 0);
}

TEST(FillCavities, AgreesWithASimpleFloodOnNoise)
{
  const DistanceGrid grid = cubicGrid(9);
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const std::vector<float> field = noise(grid, seed);
    const InsideSamples before(grid, field, 0.7);
    // Relaxation of reachability over axis neighbours until nothing changes.
    std::vector<char> reached(static_cast<std::size_t>(before.sampleCount()), 0);
    reached[0] = 1;
    for (bool changed = true; changed;)
    {
      changed = false;
      for (GridIndex s = 0; s < before.sampleCount(); ++s)
      {
        for (int axis = 0; axis < 3 && reached[static_cast<std::size_t>(s)]; ++axis)
        {
          const int position = before.lattice(s)[static_cast<std::size_t>(axis)];
          for (const int step : { -1, 1 })
          {
            if (position + step < 0 || position + step >= before.size(axis))
            {
              continue;
            }
            const GridIndex t = s + step * before.stride(axis);
            if (!before.isInside(t) && !reached[static_cast<std::size_t>(t)])
            {
              reached[static_cast<std::size_t>(t)] = 1;
              changed = true;
            }
          }
        }
      }
    }
    InsideSamples after(grid, field, 0.7);
    fillCavities(after);
    for (GridIndex s = 0; s < after.sampleCount(); ++s)
    {
      ASSERT_EQ(!after.isInside(s), reached[static_cast<std::size_t>(s)] != 0);
    }
  }
}
