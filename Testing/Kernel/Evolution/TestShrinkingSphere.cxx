// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceFlow.h"

#include "Evolution/EvolutionShapes.h"
#include "Evolution/FlowRuns.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;

namespace
{

/// e of (6.1) as METHOD settles it, over the whole run of a shrinking unit sphere.
double shrinkingSphereError(const SurfaceMesh& start, double tau, int steps, double omega)
{
  SurfaceFlow flow(start, nullptr, flows::meanCurvatureFlow(tau, steps, omega));
  double sum = 0.0;
  while (!flow.isFinished())
  {
    const std::vector<double> mu = flow.arrays().coVolume;
    flow.step();
    const double r = std::sqrt(1.0 - 4.0 * flow.record().time);
    for (std::size_t i = 0; i < mu.size(); ++i)
    {
      sum += tau * std::pow(flow.mesh().points[i].norm() - r, 2) * mu[i];
    }
  }
  EXPECT_EQ(flow.stopReason(), "");
  EXPECT_NEAR(flow.record().time, 0.06, 1e-12);
  return std::sqrt(sum);
}

} // namespace

struct SphereRow
{
  int level;
  double tau;
  int steps;
  double thesis;
  double none;
  double one;
  double hundred;
};

class ShrinkingSphereTable : public ::testing::TestWithParam<SphereRow>
{
};

TEST_P(ShrinkingSphereTable, HasTheErrorsOfTheThesis)
{
  const SphereRow row = GetParam();
  const SurfaceMesh start = icosphere(row.level);
  const double none = shrinkingSphereError(start, row.tau, row.steps, 0.0);
  EXPECT_NEAR(none, row.thesis, 1e-3 * row.thesis);
  EXPECT_NEAR(none, row.none, 1e-4 * row.none);
  EXPECT_NEAR(shrinkingSphereError(start, row.tau, row.steps, 1.0), row.one, 5e-3 * row.one);
  EXPECT_NEAR(
    shrinkingSphereError(start, row.tau, row.steps, 100.0), row.hundred, 5e-3 * row.hundred);
}

INSTANTIATE_TEST_SUITE_P(Levels, ShrinkingSphereTable,
  ::testing::Values(SphereRow{ 1, 0.01, 6, 0.00306693, 0.00306683, 0.00306683, 0.00306683 },
    SphereRow{ 2, 0.0025, 24, 0.000867587, 0.000867625, 0.000872717, 0.00100435 },
    SphereRow{ 3, 0.000625, 96, 0.000210629, 0.000210625, 0.000211283, 0.000226696 },
    SphereRow{ 4, 0.00015625, 384, 0.0000511243, 0.0000511173, 0.0000511856, 0.0000536707 }));

TEST(ShrinkingSphere, ShrinksACubeSphereOfQuads)
{
  EXPECT_NEAR(shrinkingSphereError(cubeSphere(3), 0.01, 6, 0.0), 0.0027455, 5e-3 * 0.0027455);
  EXPECT_NEAR(shrinkingSphereError(cubeSphere(6), 0.0025, 24, 0.0), 0.00067973, 5e-3 * 0.00067973);
  EXPECT_NEAR(
    shrinkingSphereError(cubeSphere(12), 0.000625, 96, 0.0), 0.00016542, 5e-3 * 0.00016542);
}

TEST(ShrinkingSphere, RegularIcosahedronOnlyShrinks)
{
  SurfaceFlow flow(icosphere(0), nullptr, flows::meanCurvatureFlow(0.01, 5, 50.0));
  flows::run(flow);
  const double radius = flow.mesh().points[0].norm();
  EXPECT_LT(radius, 0.95);
  for (std::size_t i = 0; i < 12; ++i)
  {
    EXPECT_LT((flow.mesh().points[i] - radius * icosphere(0).points[i]).norm(), 1e-9);
  }
}
