// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// The shrinking sphere with new elements at half time.

#include "Evolution/SurfaceFlow.h"

#include "Evolution/FlowRuns.h"
#include "Evolution/Remeshers.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>

using namespace evolving;

namespace
{

/// e of (6.1) over the second half of a run; with a remesher, new elements after the first.
double errorOfSecondHalf(int level, const std::shared_ptr<Remesher>& remesher, int steps)
{
  FlowOptions options = flows::meanCurvatureFlow(0.06 / steps, steps, 1.0);
  options.remeshingInterval = steps / 2;
  SurfaceFlow flow = remeshers::flowOf(icosphere(level), nullptr, remesher, options);
  double sum = 0.0;
  while (!flow.isFinished())
  {
    const std::vector<double> mu = flow.arrays().coVolume;
    flow.step();
    const double r = std::sqrt(1.0 - 4.0 * flow.record().time);
    for (std::size_t i = 0; flow.record().iteration > steps / 2 && i < mu.size(); ++i)
    {
      sum += options.timeStep * std::pow(flow.mesh().points[i].norm() - r, 2) * mu[i];
    }
  }
  EXPECT_EQ(flow.stopReason(), "");
  EXPECT_EQ(flow.record().iteration, steps);
  return std::sqrt(sum);
}

/// The error is between those of a run with the coarse elements and one with the fine ones.
/// @param refinement 1 for finer elements at half time, -1 for coarser ones
void expectSecondOrder(
  const std::function<std::shared_ptr<Remesher>(int to)>& remesher, int refinement, int firstSteps)
{
  double coarse = 0.0;
  for (int level = 1; level <= 3; ++level)
  {
    const int from = refinement > 0 ? level : level + 1;
    const int steps = firstSteps << (2 * (level - 1));
    const double error = errorOfSecondHalf(from, remesher(from + refinement), steps);
    EXPECT_LT(error, errorOfSecondHalf(level, nullptr, steps)) << "level " << level;
    EXPECT_GT(error, errorOfSecondHalf(level + 1, nullptr, steps)) << "level " << level;
    if (level > 1)
    {
      EXPECT_GT(std::log2(coarse / error), 1.7) << "to level " << level;
      EXPECT_LT(std::log2(coarse / error), 2.1) << "to level " << level;
    }
    coarse = error;
  }
}

} // namespace

TEST(RemeshedSphere, ASphereWithFinerElementsShrinksWithSecondOrder)
{
  expectSecondOrder([](int to) { return remeshers::refiner(icosphere(to).vertexCount()); }, 1, 24);
}

TEST(RemeshedSphere, ASphereWithCoarserElementsShrinksWithSecondOrder)
{
  expectSecondOrder(remeshers::sphereMaker, -1, 6);
}
