// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Tori under mean curvature flow: one that keeps its shape, and which ones close their hole.

#include "Evolution/FlowRuns.h"
#include "Shapes/SelfSimilarTorus.h"
#include "Shapes/Tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;

namespace
{

constexpr double Time = 0.3; ///< it is unstable: later errors are of nothing but the start's

/// The root of the mean squared distance from the exact torus at the end.
double errorOfRun(const shapes::SelfSimilarTorus& torus, Index rings)
{
  const int steps = 20 * rings * rings / 64; // the step goes with the square of the edges
  SurfaceFlow flow(
    torus.mesh(rings, 2 * rings), nullptr, flows::meanCurvatureFlow(Time / steps, steps));
  flows::run(flow);
  EXPECT_EQ(flow.stopReason(), "");
  double squares = 0.0;
  for (std::size_t i = 0; i < flow.mesh().points.size(); ++i)
  {
    const double distance = torus.distance(flow.mesh().points[i], Time);
    squares += flow.arrays().coVolume[i] * distance * distance;
  }
  return std::sqrt(squares / flow.record().area);
}

/// What becomes of a torus whose ring has the radius 1.
enum class Fate
{
  Unknown,
  ClosesItsHole,
  BecomesARing,
};

Fate fateOf(double tubeRadius)
{
  SurfaceFlow flow(
    shapes::torus(60, 40, 1.0, tubeRadius), nullptr, flows::meanCurvatureFlow(5e-4, 1000));
  while (!flow.isFinished())
  {
    flow.step();
    double inner = 1e300;
    double outer = 0.0;
    for (const Vec3& p : flow.mesh().points)
    {
      inner = std::min(inner, p.head<2>().norm());
      outer = std::max(outer, p.head<2>().norm());
    }
    // By then nothing else can happen: a tube closes at its own rate, 1 / radius.
    if (inner < 0.12)
    {
      return Fate::ClosesItsHole;
    }
    if (outer - inner < 0.25)
    {
      return Fate::BecomesARing;
    }
  }
  return Fate::Unknown;
}

} // namespace

TEST(SelfSimilarTorus, HasTheKnownMeasures)
{
  const shapes::SelfSimilarTorus torus;
  EXPECT_NEAR(torus.profile().back()[0], torus.OuterRadius, 1e-6);
  EXPECT_NEAR(torus.profile().back()[1], 0.0, 1e-6);
  double height = 0.0;
  for (const Eigen::Vector2d& p : torus.profile())
  {
    height = std::max(height, p[1]);
  }
  EXPECT_NEAR(height, torus.HalfHeight, 1e-6);
  const SurfaceMesh mesh = torus.mesh(128, 256);
  EXPECT_NEAR(surfaceArea(mesh), torus.Area, 1e-3 * torus.Area);
  EXPECT_NEAR(signedVolume(mesh), torus.Volume, 2e-3 * torus.Volume);
}

TEST(SelfSimilarTorus, ShrinksWithoutChangingItsShape)
{
  const shapes::SelfSimilarTorus torus;
  double coarser = errorOfRun(torus, 8);
  double order = 0.0;
  for (const Index rings : { 16, 32 })
  {
    const double error = errorOfRun(torus, rings);
    // Few rings hardly know the hole: the order is 2 in the end (CurvatureFlowStudy).
    EXPECT_GT(std::log2(coarser / error), std::max(order, 1.2)) << rings;
    order = std::log2(coarser / error);
    coarser = error;
  }
  EXPECT_GT(order, 1.5);
  EXPECT_LT(coarser, 0.006);
}

TEST(ThickTorus, ClosesItsHoleAboveACriticalRadius)
{
  EXPECT_EQ(fateOf(0.64), Fate::BecomesARing);
  EXPECT_EQ(fateOf(0.65), Fate::ClosesItsHole);
}
