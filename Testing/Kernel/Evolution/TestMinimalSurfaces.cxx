// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceFlow.h"

#include "Evolution/EvolutionShapes.h"
#include "Evolution/FlowRuns.h"

#include <gtest/gtest.h>

using namespace evolving;

TEST(MinimalSurfaces, ConvergesToTheCatenoid)
{
  // Between two circles of radius cosh(0.5) at z = +-0.5: r(z) = cosh z.
  double last = 0.0;
  for (const Index n : { 6, 12 })
  {
    const SurfaceMesh start =
      shapes::tube(6 * n, 2 * n, 0.5, [](double) { return std::cosh(0.5); });
    SurfaceFlow flow(start, nullptr, flows::meanCurvatureFlow(0.05, 60));
    flows::run(flow);
    double worst = 0.0;
    for (std::size_t i = 0; i < start.points.size(); ++i)
    {
      const Vec3& p = flow.mesh().points[i];
      worst = std::max(worst, std::abs(p.head<2>().norm() - std::cosh(p.z())));
    }
    EXPECT_LT(worst, last > 0.0 ? 0.35 * last : 0.02);
    last = worst;
    // Fixed boundary vertices keep their bits.
    for (std::size_t i = 0; i < static_cast<std::size_t>(6 * n); ++i)
    {
      EXPECT_EQ(flow.mesh().points[i], start.points[i]);
    }
  }
}

TEST(MinimalSurfaces, ABumpOnADiscFlattens)
{
  SurfaceMesh start = shapes::sheet(10, false);
  for (Vec3& p : start.points)
  {
    p.z() = 0.2 * std::sin(shapes::Pi * p.x()) * std::sin(shapes::Pi * p.y());
  }
  SurfaceFlow flow(start, nullptr, flows::meanCurvatureFlow(0.05, 40));
  flows::run(flow);
  EXPECT_NEAR(flow.record().area, 1.0, 1e-9);
  for (const Vec3& p : flow.mesh().points)
  {
    EXPECT_NEAR(p.z(), 0.0, 1e-6);
  }
}
