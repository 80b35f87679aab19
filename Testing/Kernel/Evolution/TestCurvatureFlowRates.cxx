// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// dA/dt = -(integral of H^2) and dV/dt = -(integral of H), as the scheme itself has them.

#include "Evolution/FlowRuns.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;

namespace
{

/// Relative errors of the area's and the volume's change.
struct RateErrors
{
  double area = 0.0;
  double volume = 0.0;
};

struct Integrals
{
  double ofSquare = 0.0; ///< H^2
  double ofCurvature = 0.0;
};

Integrals integralsOf(const SurfaceFlow& flow)
{
  Integrals integrals;
  for (std::size_t i = 0; i < flow.arrays().meanCurvature.size(); ++i)
  {
    const double H = flow.arrays().meanCurvature[i];
    integrals.ofSquare += flow.arrays().coVolume[i] * H * H;
    integrals.ofCurvature += flow.arrays().coVolume[i] * H;
  }
  return integrals;
}

/// Over a fixed time, in steps that go with the square of the edges, by the trapezoidal rule.
RateErrors errorsOfRun(int level)
{
  const int steps = 10 << (2 * (level - 2));
  const double timeStep = 0.1 / steps;
  SurfaceFlow flow(shapes::ellipsoid(level, Vec3(3.0, 2.0, 1.0)), nullptr,
    flows::meanCurvatureFlow(timeStep, steps));
  const FlowRecord first = flow.record();
  Integrals sum;
  Integrals before = integralsOf(flow);
  while (!flow.isFinished())
  {
    flow.step();
    const Integrals now = integralsOf(flow);
    sum.ofSquare += 0.5 * timeStep * (before.ofSquare + now.ofSquare);
    sum.ofCurvature += 0.5 * timeStep * (before.ofCurvature + now.ofCurvature);
    before = now;
  }
  return { std::abs((first.area - flow.record().area) / sum.ofSquare - 1.0),
    std::abs((first.volume - flow.record().volume) / sum.ofCurvature - 1.0) };
}

} // namespace

TEST(CurvatureFlowRates, AreTheIntegralsOfCurvatureWithSecondOrder)
{
  RateErrors coarser = errorsOfRun(2);
  for (const int level : { 3, 4 })
  {
    const RateErrors errors = errorsOfRun(level);
    EXPECT_GT(std::log2(coarser.area / errors.area), 1.7) << level;
    EXPECT_GT(std::log2(coarser.volume / errors.volume), 1.7) << level;
    coarser = errors;
  }
  EXPECT_LT(coarser.area, 0.01);
  EXPECT_LT(coarser.volume, 0.01);
}
