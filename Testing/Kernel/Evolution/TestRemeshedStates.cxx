// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// The states of a flow with other elements now and then: sizes, sharing, threads, resuming.

#include "Evolution/SurfaceFlow.h"

#include "Evolution/EvolutionFields.h"
#include "Evolution/FlowRuns.h"
#include "Evolution/Remeshers.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <vector>

using namespace evolving;

namespace
{

/// Every state of a run towards a sphere with other elements after every third step.
std::vector<FlowState> statesOfARun(const Execution& execution)
{
  FlowOptions options = flows::towardsSphere(8);
  options.remeshingInterval = 3;
  SurfaceFlow flow = remeshers::flowOf(shapes::bumpySphere(3), shapes::sphereField(41, 1.6, 0.5),
    remeshers::byRule([](const SurfaceMesh& mesh, const std::vector<double>& /*distance*/)
      { return std::make_optional(icosphere(mesh.vertexCount() == 642 ? 2 : 3, 0.9)); }),
    options, execution);
  std::vector<FlowState> states = { flow.state() };
  while (!flow.isFinished())
  {
    flow.step();
    states.push_back(flow.state());
  }
  EXPECT_EQ(flow.stopReason(), "");
  return states;
}

} // namespace

TEST(RemeshedStates, StatesShareTheirOrigin)
{
  const std::vector<FlowState> states = statesOfARun(Execution());
  ASSERT_EQ(states.size(), 9u);
  const std::vector<std::size_t> counts = { 642, 642, 642, 162, 162, 162, 642, 642, 162 };
  for (std::size_t k = 0; k < states.size(); ++k)
  {
    EXPECT_EQ(states[k].points.size(), counts[k]) << k;
    EXPECT_TRUE(remeshers::fit(states[k].arrays, counts[k])) << k;
    EXPECT_EQ(states[k].mesh().faceCount(), 2 * static_cast<Index>(counts[k]) - 4) << k;
    EXPECT_EQ(k > 0 && states[k].origin == states[k - 1].origin, k % 3 != 0 && k != 8) << k;
  }
}

TEST(RemeshedStates, HasTheSameBitsOnAnyNumberOfThreads)
{
  const std::vector<FlowState> one = statesOfARun(threadedExecution(1, 1));
  for (const int threads : { 2, 8 })
  {
    const std::vector<FlowState> many =
      statesOfARun(threadedExecution(threads, static_cast<unsigned>(threads)));
    ASSERT_EQ(many.size(), one.size());
    for (std::size_t k = 0; k < one.size(); ++k)
    {
      EXPECT_TRUE(many[k].mesh() == one[k].mesh()) << k;
      EXPECT_TRUE(many[k].arrays.tangentialVelocity == one[k].arrays.tangentialVelocity) << k;
      EXPECT_EQ(many[k].record.area, one[k].record.area) << k;
    }
  }
}

TEST(RemeshedStates, GoesOnFromAnyState)
{
  const std::vector<FlowState> states = statesOfARun(Execution());
  FlowOptions options = flows::towardsSphere(8);
  options.remeshingInterval = 9;
  const auto field = shapes::sphereField(41, 1.6, 0.5);
  // Flows at their start, with other elements than the states.
  SurfaceFlow flow(shapes::bumpySphere(3), field, options);
  for (const std::size_t k : { std::size_t(3), std::size_t(4), std::size_t(6), std::size_t(0) })
  {
    flow.resume(states[k]);
    EXPECT_EQ(flow.record().iteration, static_cast<int>(k));
    EXPECT_TRUE(flow.mesh() == states[k].mesh());
    flow.step();
    ASSERT_EQ(flow.mesh().points.size(), states[k + 1].points.size());
    for (std::size_t i = 0; i < flow.mesh().points.size(); ++i)
    {
      EXPECT_LT((flow.mesh().points[i] - states[k + 1].points[i]).norm(), 1e-8);
    }
  }
}

TEST(RemeshedStates, ABoundaryGoesOnAlongThatOfItsOrigin)
{
  FlowOptions options = flows::meanCurvatureFlow(0.002, 20, 1.0);
  options.boundaryMode = BoundaryMode::SlideAlong;
  options.redistribution.length = 50.0;
  options.remeshingInterval = 10;
  const SurfaceMesh start = shapes::shakenInside(shapes::halfSphere(6), 0.03, 7);
  const auto flow = [&]
  { return remeshers::flowOf(start, nullptr, remeshers::refiner(200), options); };
  SurfaceFlow first = flow();
  while (first.record().iteration < 15)
  {
    first.step();
  }
  EXPECT_FALSE(first.state().points == first.state().origin->points);
  SurfaceFlow second = flow();
  second.resume(first.state());
  flows::run(first);
  flows::run(second);
  ASSERT_TRUE(haveEqualFaces(first.mesh(), second.mesh()));
  for (std::size_t i = 0; i < first.mesh().points.size(); ++i)
  {
    EXPECT_LT((first.mesh().points[i] - second.mesh().points[i]).norm(), 1e-8);
  }
}
