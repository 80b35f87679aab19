// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// What a series of states really holds.

#include "Evolution/StateSeries.h"

#include "Evolution/EvolutionFields.h"
#include "Evolution/Remeshers.h"
#include "MemoryCount.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

using namespace evolving;

namespace
{

constexpr int Steps = 150;
constexpr double MiB = 1024.0 * 1024.0;

/// Memory in MiB: held when the series is there, and at most while it was made.
struct Memory
{
  double held = 0.0;
  double peak = 0.0;
};

/// Of a flow with 2562 vertices, which publishes every interval-th of its 150 steps.
Memory memoryOfASeries(
  double limit, int interval, const std::shared_ptr<Remesher>& remesher = nullptr)
{
  FlowOptions options;
  options.relativeUnits = false;
  options.timeStep = 1e-4;
  options.numberOfSteps = Steps;
  options.redistribution.volume = 1.0;
  const auto start = std::make_shared<const SurfaceMesh>(shapes::bumpySphere(4));
  const auto field = shapes::sphereField(24, 2.0, 0.5);
  const MemoryCount count;
  std::size_t peak = 0;
  const Execution watched(
    nullptr, [&](double) { peak = std::max(peak, count.held()); }, nullptr);
  const StateSeries series([=](const Execution& host)
    { return SurfaceFlow(start, field, remesher, options, host); },
    publishedIterations(Steps, 0, interval), static_cast<std::size_t>(limit * MiB), watched);
  EXPECT_EQ(series.lastIteration(), Steps);
  return { static_cast<double>(count.held()) / MiB, static_cast<double>(peak) / MiB };
}

/// Points, gradients, normals, velocities, and six numbers a vertex.
constexpr double OneState = 2562 * (4 * 3 + 6) * sizeof(double) / MiB;

} // namespace

TEST(StateSeriesMemory, ASeriesHoldsItsStatesAndLittleElse)
{
  if (!MemoryCount::isSupported())
  {
    GTEST_SKIP() << "nothing counts memory here";
  }
  const Memory all = memoryOfASeries(1000.0, 1);
  EXPECT_GT(all.held, (Steps + 1) * OneState);
  EXPECT_LT(all.held, 1.02 * (Steps + 1) * OneState);
}

TEST(StateSeriesMemory, TheLimitHoldsDuringTheSolveToo)
{
  if (!MemoryCount::isSupported())
  {
    GTEST_SKIP() << "nothing counts memory here";
  }
  // The flow's own memory, with the first and the last state alone.
  const Memory ends = memoryOfASeries(1000.0, Steps);
  for (const double limit : { 2.0, 8.0, 16.0 })
  {
    const Memory series = memoryOfASeries(limit, 1);
    // The history is no state.
    EXPECT_LT(series.held, limit + 0.1) << limit;
    EXPECT_GT(series.held, 0.45 * limit) << limit;
    // One state more is there before they are thinned out, as many as the ends' peak has.
    EXPECT_LT(series.peak, ends.peak + limit + 0.1) << limit;
  }
}

TEST(StateSeriesMemory, TheLimitHoldsWithNewElementsInEveryStep)
{
  if (!MemoryCount::isSupported())
  {
    GTEST_SKIP() << "nothing counts memory here";
  }
  for (const double limit : { 4.0, 16.0 })
  {
    const Memory series = memoryOfASeries(limit, 1, remeshers::renumberer());
    EXPECT_LT(series.held, limit + 0.1) << limit;
    EXPECT_GT(series.held, 0.45 * limit) << limit;
  }
}

TEST(StateSeriesMemory, TheEndsAreKeptWhateverTheLimit)
{
  if (!MemoryCount::isSupported())
  {
    GTEST_SKIP() << "nothing counts memory here";
  }
  const Memory least = memoryOfASeries(0.0, 1);
  EXPECT_GT(least.held, 2 * OneState);
  EXPECT_LT(least.held, 2 * OneState + 0.1);
}
