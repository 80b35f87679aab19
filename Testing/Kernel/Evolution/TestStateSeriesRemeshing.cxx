// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Series whose states have different elements.

#include "Evolution/StateSeries.h"

#include "Checks/SurfaceMeasures.h"
#include "Evolution/EvolutionFields.h"
#include "Evolution/FlowRuns.h"
#include "Evolution/Remeshers.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>

using namespace evolving;

namespace
{

constexpr std::size_t NoLimit = std::numeric_limits<std::size_t>::max();
constexpr int Steps = 20;

/// From 162 vertices to 642 after step 6, and back to 162 after step 12.
StateSeries refinedAndCoarsened(std::size_t memoryLimit, int* made)
{
  FlowOptions options = flows::meanCurvatureFlow(0.002, Steps, 1.0);
  options.remeshingInterval = 6;
  const auto start = std::make_shared<const SurfaceMesh>(icosphere(2));
  const auto remesher = remeshers::byRule(
    [](const SurfaceMesh& mesh,
      const std::vector<double>& /*distance*/) -> std::optional<SurfaceMesh>
    {
      const double radius = checks::meanRadius(mesh);
      if (radius < 0.96) // at step 12, not at step 6
      {
        return mesh.vertexCount() == 642 ? std::make_optional(icosphere(2, radius)) : std::nullopt;
      }
      return remeshers::inFour(mesh);
    });
  const auto make = [=](const Execution& host)
  {
    ++*made;
    return SurfaceFlow(start, nullptr, remesher, options, host);
  };
  return StateSeries(make, publishedIterations(Steps, 0, 1), memoryLimit, Execution());
}

Index expectedVertices(int step)
{
  return step >= 6 && step < 12 ? 642 : 162;
}

void expectState(StateSeries& series, int step)
{
  const auto state = series.state(static_cast<std::size_t>(step), Execution());
  const SurfaceMesh mesh = state->mesh();
  EXPECT_EQ(state->record.iteration, step);
  EXPECT_EQ(mesh.vertexCount(), expectedVertices(step)) << step;
  EXPECT_EQ(mesh.faceCount(), 2 * mesh.vertexCount() - 4) << step;
  EXPECT_EQ(state->arrays.normal.size(), mesh.points.size()) << step;
  EXPECT_EQ(state->arrays.tangentialVelocity.size(), mesh.points.size()) << step;
  EXPECT_NEAR(state->record.area, surfaceArea(mesh), 1e-12) << step;
  EXPECT_NEAR(checks::meanRadius(mesh), std::sqrt(1.0 - 4.0 * state->record.time), 0.003);
}

/// Bytes of a state with 642 vertices and its origin, without a field.
constexpr std::size_t LargeState = 642 * (4 * 3 + 5) * sizeof(double) + 1281 * 4 * sizeof(Index);

} // namespace

TEST(StateSeriesRemeshing, StatesHaveTheirElementsForwardsAndBackwards)
{
  int made = 0;
  StateSeries series = refinedAndCoarsened(NoLimit, &made);
  ASSERT_EQ(series.history().size(), static_cast<std::size_t>(Steps + 1));
  for (int step = 0; step <= Steps; ++step)
  {
    EXPECT_EQ(series.history()[static_cast<std::size_t>(step)].iteration, step);
    expectState(series, step);
  }
  for (int step = Steps; step >= 0; --step)
  {
    expectState(series, step);
  }
  EXPECT_EQ(made, 1);
}

TEST(StateSeriesRemeshing, DroppedStatesGetTheirElementsAgain)
{
  int made = 0;
  StateSeries whole = refinedAndCoarsened(NoLimit, &made);
  StateSeries tight = refinedAndCoarsened(3 * LargeState, &made);
  made = 0;
  for (const int step : { 20, 19, 13, 12, 11, 7, 6, 5, 1, 0, 6, 12 })
  {
    expectState(tight, step);
    const auto state = tight.state(static_cast<std::size_t>(step), Execution());
    const auto expected = whole.state(static_cast<std::size_t>(step), Execution());
    EXPECT_TRUE(haveEqualFaces(*state->origin, *expected->origin)) << step;
    for (std::size_t i = 0; i < state->points.size(); ++i)
    {
      EXPECT_LT((state->points[i] - expected->points[i]).norm(), 1e-8) << step;
    }
  }
  EXPECT_GT(made, 0);
}

TEST(StateSeriesRemeshing, KeptStatesShareWhatRemeshingGaveThem)
{
  int made = 0;
  StateSeries series = refinedAndCoarsened(NoLimit, &made);
  const auto origin = [&](std::size_t i) { return series.state(i, Execution())->origin.get(); };
  for (std::size_t step = 1; step <= Steps; ++step)
  {
    EXPECT_EQ(origin(step) == origin(step - 1), step != 6 && step != 12) << step;
  }
}
