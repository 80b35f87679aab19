// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/StateSeries.h"

#include "Errors.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <utility>

using namespace evolving;

namespace
{

constexpr std::size_t NoLimit = std::numeric_limits<std::size_t>::max();

FlowOptions exampleOptions(int steps, int smoothingSteps)
{
  FlowOptions options;
  options.relativeUnits = false;
  options.timeStep = 0.002;
  options.numberOfSteps = steps;
  options.redistribution.volume = 1.0;
  options.smoothingSteps = smoothingSteps;
  options.smoothingSpeed = 0.1;
  return options;
}

/// Counts how often a flow is made: once per solve.
struct Maker
{
  FlowOptions options;
  int* count;

  SurfaceFlow operator()(const Execution& execution) const
  {
    ++*this->count;
    return SurfaceFlow(shapes::bumpySphere(2), nullptr, this->options, execution);
  }
};

} // namespace

TEST(StateSeries, PublishesStartIntervalsAndEnds)
{
  EXPECT_EQ(publishedIterations(0, 0, 1), (std::vector<int>{ 0 }));
  EXPECT_EQ(publishedIterations(3, 0, 1), (std::vector<int>{ 0, 1, 2, 3 }));
  EXPECT_EQ(publishedIterations(10, 0, 4), (std::vector<int>{ 0, 4, 8, 10 }));
  EXPECT_EQ(publishedIterations(8, 0, 4), (std::vector<int>{ 0, 4, 8 }));
  EXPECT_EQ(publishedIterations(5, 5, 2), (std::vector<int>{ 0, 2, 4, 5, 7, 9, 10 }));
  EXPECT_EQ(publishedIterations(0, 3, 5), (std::vector<int>{ 0, 3 }));
}

TEST(StateSeries, KeepsTheStatesOfOneRun)
{
  int made = 0;
  const Maker maker{ exampleOptions(6, 3), &made };
  StateSeries series(maker, publishedIterations(6, 3, 2), NoLimit, Execution());
  EXPECT_EQ(made, 1);
  EXPECT_EQ(series.history().size(), 10u);
  EXPECT_EQ(series.lastIteration(), 9);
  SurfaceFlow flow = maker(Execution());
  const std::vector<int> published = publishedIterations(6, 3, 2);
  for (std::size_t i = 0; i < published.size(); ++i)
  {
    while (flow.record().iteration < published[i])
    {
      flow.step();
    }
    const auto state = series.state(i, Execution());
    EXPECT_EQ(state->record.iteration, published[i]);
    EXPECT_TRUE(state->points == flow.mesh().points);
  }
  EXPECT_EQ(made, 2); // the one above
}

TEST(StateSeries, ComputesDroppedStatesAgain)
{
  int made = 0;
  const std::vector<int> published = publishedIterations(16, 0, 1);
  const Maker maker{ exampleOptions(16, 0), &made };
  StateSeries whole(maker, published, NoLimit, Execution());
  const FlowState& last = *whole.state(16, Execution());
  const std::size_t oneState = last.points.size() * (3 * sizeof(Vec3) + 4 * sizeof(double));
  StateSeries thinned(maker, published, 6 * oneState, Execution());
  made = 0;
  for (std::size_t i : { std::size_t(16), std::size_t(3), std::size_t(0), std::size_t(9) })
  {
    const auto state = thinned.state(i, Execution());
    const auto expected = whole.state(i, Execution());
    EXPECT_EQ(state->record.iteration, published[i]);
    for (std::size_t k = 0; k < state->points.size(); ++k)
    {
      EXPECT_LT((state->points[k] - expected->points[k]).norm(), 1e-8);
    }
  }
  EXPECT_GT(made, 0);
  EXPECT_LE(made, 2); // the ends are kept
}

TEST(StateSeries, RepeatsTheLastStateAfterAnEarlyEnd)
{
  int made = 0;
  FlowOptions options = exampleOptions(200, 0);
  options.timeStep = 0.02; // the sphere vanishes on the way
  StateSeries series(Maker{ options, &made }, publishedIterations(200, 0, 1), NoLimit, Execution());
  EXPECT_TRUE(series.extinctionTime());
  EXPECT_LT(series.lastIteration(), 100);
  EXPECT_EQ(series.state(200, Execution())->record.iteration, series.history().back().iteration);
}

TEST(StateSeries, ForgetsTheFlowWhenNoStateWasDropped)
{
  for (const std::size_t limit : { NoLimit, std::size_t(0) })
  {
    auto held = std::make_shared<int>(0);
    const std::weak_ptr<int> watched = held;
    StateSeries series([held = std::move(held)](const Execution& host)
      { return SurfaceFlow(shapes::bumpySphere(2), nullptr, exampleOptions(6, 0), host); },
      publishedIterations(6, 0, 1), limit, Execution());
    EXPECT_EQ(watched.expired(), limit == NoLimit);
    for (std::size_t i = 0; i <= 6; ++i)
    {
      EXPECT_EQ(series.state(i, Execution())->record.iteration, static_cast<int>(i));
    }
  }
}

TEST(StateSeries, CanBeCancelled)
{
  int made = 0;
  const Execution stopped(nullptr, nullptr, [] { return true; });
  EXPECT_THROW(StateSeries(Maker{ exampleOptions(5, 0), &made }, publishedIterations(5, 0, 1),
                 NoLimit, stopped),
    Cancelled);
}
