// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Surfaces in fixed boundaries relax to the minimal surfaces that are known.

#include "Evolution/SurfaceFlow.h"

#include "Evolution/FlowRuns.h"
#include "Mesh/Angles.h"
#include "Mesh/MeshQuality.h"
#include "Mesh/MeshTopology.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Sheets.h"
#include "Shapes/Tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;

namespace
{

/// The largest distance in radius from r(z) = cosh z, between circles at z = +-0.5.
double catenoidError(Index n)
{
  const SurfaceMesh start = shapes::tube(6 * n, 2 * n, 0.5, [](double) { return std::cosh(0.5); });
  SurfaceFlow flow(start, nullptr, flows::meanCurvatureFlow(0.2, 30));
  flows::run(flow);
  EXPECT_EQ(flow.stopReason(), "");
  double worst = 0.0;
  for (const Vec3& p : flow.mesh().points)
  {
    worst = std::max(worst, std::abs(p.head<2>().norm() - std::cosh(p.z())));
  }
  // Fixed boundary vertices keep their bits.
  for (std::size_t i = 0; i < static_cast<std::size_t>(6 * n); ++i)
  {
    EXPECT_EQ(flow.mesh().points[i], start.points[i]);
  }
  return worst;
}

/// A flat disc with shaken vertices, tilted and off the origin.
struct TiltedDisc
{
  Eigen::Matrix3d rotation = shapes::someRotation();
  Vec3 centre = Vec3(2.0, -1.0, 0.5);
  SurfaceMesh mesh = shapes::transformed(
    shapes::mapped(shapes::shakenInside(shapes::disc(8), 0.03, 4), rotation), 1.0, centre);

  double height(const Vec3& point) const { return this->rotation.col(2).dot(point - this->centre); }
};

RedistributionOptions allKinds()
{
  RedistributionOptions options;
  options.volume = 1.0;
  options.angle = 1.0;
  options.length = 1.0;
  return options;
}

/// Runs the disc's flow and checks what holds whatever moves inside.
SurfaceFlow runPlanar(const TiltedDisc& disc, const RedistributionOptions& redistribution)
{
  FlowOptions options = flows::meanCurvatureFlow(0.01, 30);
  options.redistribution = redistribution;
  SurfaceFlow flow(disc.mesh, nullptr, options);
  flows::run(flow);
  EXPECT_EQ(flow.stopReason(), "");
  EXPECT_NEAR(flow.record().area, surfaceArea(disc.mesh), 1e-13); // no fold
  const MeshTopology topology(disc.mesh);
  for (Index i = 0; i < disc.mesh.vertexCount(); ++i)
  {
    const auto v = static_cast<std::size_t>(i);
    EXPECT_NEAR(disc.height(flow.mesh().points[v]), 0.0, 1e-14);
    EXPECT_TRUE(!topology.isBoundary(i) || flow.mesh().points[v] == disc.mesh.points[v]);
  }
  return flow;
}

} // namespace

TEST(MinimalSurfaces, TheCatenoidIsReachedWithSecondOrder)
{
  double coarse = catenoidError(4);
  EXPECT_LT(coarse, 0.005);
  for (const Index n : { 8, 16, 32 })
  {
    const double fine = catenoidError(n);
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.05) << "from " << n / 2 << " to " << n;
    coarse = fine;
  }
}

TEST(MinimalSurfaces, ABumpOnASquareFlattens)
{
  SurfaceMesh start = shapes::sheet(10, false);
  for (Vec3& p : start.points)
  {
    p.z() = 0.2 * std::sin(Pi * p.x()) * std::sin(Pi * p.y());
  }
  SurfaceFlow flow(start, nullptr, flows::meanCurvatureFlow(0.05, 40));
  flows::run(flow);
  EXPECT_NEAR(flow.record().area, 1.0, 1e-9);
  for (const Vec3& p : flow.mesh().points)
  {
    EXPECT_NEAR(p.z(), 0.0, 1e-6);
  }
}

TEST(MinimalSurfaces, APlanarDiscDoesNotMove)
{
  // However irregular its inside is: linear functions have no Laplacian in the plane.
  const TiltedDisc disc;
  const SurfaceFlow flow = runPlanar(disc, RedistributionOptions());
  for (std::size_t i = 0; i < disc.mesh.points.size(); ++i)
  {
    EXPECT_LT((flow.mesh().points[i] - disc.mesh.points[i]).norm(), 1e-13);
  }
}

TEST(MinimalSurfaces, RedistributionOfAPlanarDiscStaysInItsPlaneAndBoundary)
{
  const TiltedDisc disc;
  const SurfaceFlow flow = runPlanar(disc, allKinds());
  EXPECT_LT(smallestAngle(disc.mesh), 26.0);
  EXPECT_GT(flow.record().minAngle, 31.0);
}
