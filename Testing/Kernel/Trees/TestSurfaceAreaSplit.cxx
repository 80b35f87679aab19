// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Trees/SurfaceAreaSplit.h"

#include <gtest/gtest.h>

#include <random>

using namespace evolving;

namespace
{

std::vector<SplitInterval> randomIntervals(int count, std::uint32_t seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
  std::vector<SplitInterval> intervals;
  for (int n = 0; n < count; ++n)
  {
    // Two thirds of the intervals in the last tenth.
    const float low = n % 3 == 0 ? uniform(random) : 0.9F + 0.1F * uniform(random);
    intervals.push_back({ low, std::min(1.0F, low + 0.02F * uniform(random)) });
  }
  return intervals;
}

/// The cost by the definition, for a box of sides (2, 1, 1) split along x.
double costByDefinition(const std::vector<SplitInterval>& intervals, double t)
{
  double left = 0.0;
  double right = 0.0;
  for (const SplitInterval& interval : intervals)
  {
    left += static_cast<double>(interval.low) < t ? 1.0 : 0.0;
    right += static_cast<double>(interval.high) > t ? 1.0 : 0.0;
  }
  const auto area = [](double x) { return 2.0 * (2.0 * x * 1.0 + 2.0 * x * 1.0 + 1.0 * 1.0); };
  return (left * area(t) + right * area(1.0 - t)) / area(1.0);
}

} // namespace

TEST(SurfaceAreaSplit, SamplesTheCostFunction)
{
  const auto intervals = randomIntervals(3000, 3);
  const SplitSearch search = searchSplit(Vec3(2, 1, 1), 0, intervals);
  for (std::size_t k = 1; k + 1 < search.samples.size(); ++k)
  {
    const auto t = static_cast<double>(search.samples[k].position);
    EXPECT_NEAR(search.samples[k].cost, costByDefinition(intervals, t), 0.05) << t;
    EXPECT_LE(search.samples[k - 1].position, search.samples[k].position);
  }
}

TEST(SurfaceAreaSplit, PlacesFourSamplesWhereCountsChangeFastest)
{
  const SplitSearch search = searchSplit(Vec3(2, 1, 1), 0, randomIntervals(3000, 3));
  int dense = 0;
  for (const SplitSample& sample : search.samples)
  {
    dense += sample.position > 0.8F && sample.position < 1.0F ? 1 : 0;
  }
  EXPECT_GE(dense, 3);
}

TEST(SurfaceAreaSplit, ParabolasPassThroughTheSamples)
{
  const SplitSearch search = searchSplit(Vec3(2, 1, 1), 0, randomIntervals(3000, 5));
  for (std::size_t k = 0; k < search.parabolas.size(); ++k)
  {
    const SplitParabola& parabola = search.parabolas[k];
    EXPECT_NEAR(parabola.at(parabola.from), search.samples[k].cost, 0.5F);
    EXPECT_NEAR(parabola.at(parabola.to), search.samples[k + 1].cost, 0.5F);
  }
}

TEST(SurfaceAreaSplit, IsNearlyAsGoodAsTheBestOfAThousandPositions)
{
  for (const std::uint32_t seed : { 1U, 2U, 3U, 4U, 5U })
  {
    const auto intervals = randomIntervals(3000, seed);
    const SplitSearch search = searchSplit(Vec3(2, 1, 1), 0, intervals);
    double best = std::numeric_limits<double>::infinity();
    for (int n = 1; n < 1000; ++n)
    {
      best = std::min(best, costByDefinition(intervals, n / 1000.0));
    }
    EXPECT_LT(costByDefinition(intervals, static_cast<double>(search.position)), 1.05 * best);
  }
}

TEST(SurfaceAreaSplit, CutsTheEmptySideOff)
{
  const std::vector<SplitInterval> intervals(100, { 0.75F, 1.0F });
  const SplitSearch search = searchSplit(Vec3(1, 1, 1), 0, intervals);
  EXPECT_GT(search.position, 0.5F);
  EXPECT_LE(search.position, 0.8F);
}

TEST(SurfaceAreaSplit, StaysInsideForEveryInput)
{
  for (const auto& intervals :
    { std::vector<SplitInterval>(5, { 0.0F, 1.0F }), std::vector<SplitInterval>(5, { 0.0F, 0.0F }),
      std::vector<SplitInterval>(5, { 1.0F, 1.0F }),
      std::vector<SplitInterval>(1, { 0.5F, 0.5F }) })
  {
    for (const Vec3& sides :
      { Vec3(1, 1, 1), Vec3(1, 0, 0), Vec3(1e30, 1e29, 1), Vec3(1e-30, 0, 0) })
    {
      const SplitSearch search = searchSplit(sides, 0, intervals);
      EXPECT_GT(search.position, 0.0F);
      EXPECT_LT(search.position, 1.0F);
      EXPECT_TRUE(std::isfinite(search.cost));
    }
  }
}
