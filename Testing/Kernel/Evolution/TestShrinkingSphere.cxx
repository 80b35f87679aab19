// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceFlow.h"

#include "Evolution/FlowRuns.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/MixedPolygons.h"
#include "StartSurface/PrimitiveSurfaces.h"

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

TEST(ShrinkingSphere, ConvergesOnTrianglesQuadsPentagonsAndHexagonsTogether)
{
  double coarse = shrinkingSphereError(shapes::mixedSphere(2), 0.0025, 24, 0.0);
  EXPECT_LT(coarse, 0.001);
  for (const int level : { 3, 4 })
  {
    const int steps = 96 << (2 * (level - 3));
    const double fine = shrinkingSphereError(shapes::mixedSphere(level), 0.06 / steps, steps, 0.0);
    EXPECT_GT(std::log2(coarse / fine), 1.65) << "to level " << level;
    EXPECT_LT(std::log2(coarse / fine), 2.1) << "to level " << level;
    coarse = fine;
  }
}

TEST(ShrinkingSphere, EveryComponentShrinksByItsOwnRadius)
{
  // A sphere of triangles and a smaller one of quads, with redistribution per component.
  const SurfaceMesh first = icosphere(3);
  const SurfaceMesh second = shapes::transformed(cubeSphere(12), 0.6, Vec3(3.0, 0.0, 0.0));
  SurfaceFlow flow(
    shapes::merged(first, second), nullptr, flows::meanCurvatureFlow(0.0005, 120, 1.0));
  flows::run(flow);
  EXPECT_EQ(flow.stopReason(), "");
  for (std::size_t i = 0; i < flow.mesh().points.size(); ++i)
  {
    const bool isFirst = i < first.points.size();
    const double radius = isFirst ? 1.0 : 0.6;
    const Vec3 centre = isFirst ? Vec3(Vec3::Zero()) : Vec3(3.0, 0.0, 0.0);
    EXPECT_NEAR((flow.mesh().points[i] - centre).norm(), std::sqrt(radius * radius - 0.24), 0.003);
  }
}
