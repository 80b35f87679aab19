// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/SurfaceRedistribution.h"

#include "Checks/SurfaceMeasures.h"
#include "Errors.h"
#include "Mesh/MeshQuality.h"
#include "Mesh/MeshTopology.h"
#include "Redistribution/SurfaceProjector.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;

namespace
{

/// A sphere whose vertices crowd at one side.
SurfaceMesh crowdedSphere(int level)
{
  SurfaceMesh mesh = icosphere(level);
  for (Vec3& p : mesh.points)
  {
    p = (p + Vec3(0.2, 0.1, 0.4)).normalized();
  }
  return mesh;
}

double farthestFrom(const SurfaceMesh& target, const std::vector<Vec3>& points)
{
  const SurfaceProjector projector(target);
  double farthest = 0.0;
  for (const Vec3& p : points)
  {
    farthest = std::max(farthest, (projector.project(p, Vec3::Zero(), p) - p).norm());
  }
  return farthest;
}

SurfaceRedistributionOptions only(double volume, double angle, double length)
{
  SurfaceRedistributionOptions options;
  options.redistribution.volume = volume;
  options.redistribution.angle = angle;
  options.redistribution.length = length;
  options.redistribution.angleMethod = AngleMethod::WeightedEdges;
  return options;
}

} // namespace

TEST(SurfaceRedistribution, DefaultsImproveACrowdedSphereAndKeepItsShape)
{
  const SurfaceMesh input = crowdedSphere(3);
  const auto result = redistributeSurface(input, SurfaceRedistributionOptions());
  EXPECT_EQ(result.mesh.cornerVertices, input.cornerVertices);
  EXPECT_GT(summarizeAngles(result.mesh).mean, summarizeAngles(input).mean);
  EXPECT_GE(smallestAngle(result.mesh), smallestAngle(input));
  EXPECT_LT(farthestFrom(input, result.mesh.points), 1e-12);
  EXPECT_EQ(result.arrays.normal.size(), input.points.size());
}

TEST(SurfaceRedistribution, VolumeMakesAreasEqual)
{
  const SurfaceMesh input = crowdedSphere(3);
  const auto options = only(1.0, 0.0, 0.0);
  const auto result = redistributeSurface(input, options);
  const auto start = redistributeSurface(input, only(0.0, 0.0, 0.0));
  EXPECT_TRUE(start.mesh.points == input.points); // nothing switched on: same bits
  EXPECT_LT(checks::relativeSpread(result.arrays.coVolume),
    0.15 * checks::relativeSpread(start.arrays.coVolume));
}

TEST(SurfaceRedistribution, CurvatureControlMakesTipsFiner)
{
  const SurfaceMesh input = shapes::ellipsoid(3, Vec3(2, 1, 1));
  SurfaceRedistributionOptions options = only(1.0, 0.0, 0.0);
  options.redistribution.curvatureControl = CurvatureControl::TwoThirds;
  options.numberOfSteps = 100;
  const auto result = redistributeSurface(input, options);
  double tip = 0.0;
  double side = 0.0;
  int atTip = 0;
  int atSide = 0;
  for (std::size_t i = 0; i < input.points.size(); ++i)
  {
    const double x = std::abs(result.mesh.points[i].x());
    tip += x > 1.9 ? result.arrays.coVolume[i] : 0.0;
    atTip += x > 1.9 ? 1 : 0;
    side += x < 0.3 ? result.arrays.coVolume[i] : 0.0;
    atSide += x < 0.3 ? 1 : 0;
  }
  ASSERT_GT(atTip, 3);
  EXPECT_GT(side / atSide, 1.5 * tip / atTip); // (4 / 1.25)^(2/3) = 2.2 in the limit
}

TEST(SurfaceRedistribution, KeepsSharpEdgesAndCorners)
{
  SurfaceMesh input = subdividedBox(6);
  for (Vec3& p : input.points) // crowd the vertices, the box stays
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = p[axis] + 0.4 * (0.25 - p[axis] * p[axis]);
    }
  }
  const auto result = redistributeSurface(input, only(1.0, 0.0, 0.0));
  double moved = 0.0;
  for (std::size_t i = 0; i < input.points.size(); ++i)
  {
    const Vec3& p = input.points[i];
    const Vec3& q = result.mesh.points[i];
    moved = std::max(moved, (p - q).norm());
    int sides = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      if (std::abs(std::abs(p[axis]) - 0.5) < 1e-12)
      {
        EXPECT_NEAR(p[axis], q[axis], 1e-12); // sides, edges: stay where they are
        ++sides;
      }
    }
    EXPECT_TRUE(sides != 3 || p == q); // corners
  }
  EXPECT_GT(moved, 0.02);
}

TEST(SurfaceRedistribution, ObeysTheBoundaryMode)
{
  const SurfaceMesh input = shapes::shakenSheet(8, true, 0.4, 5);
  SurfaceRedistributionOptions options;
  options.boundaryMode = BoundaryMode::Fixed;
  const auto fixed = redistributeSurface(input, options);
  options.boundaryMode = BoundaryMode::SlideAlong;
  const auto sliding = redistributeSurface(input, options);
  const MeshTopology topology(input);
  double slid = 0.0;
  for (Index i = 0; i < input.vertexCount(); ++i)
  {
    const auto v = static_cast<std::size_t>(i);
    if (topology.isBoundary(i))
    {
      EXPECT_EQ(fixed.mesh.points[v], input.points[v]);
      slid = std::max(slid, (sliding.mesh.points[v] - input.points[v]).norm());
    }
  }
  EXPECT_GT(slid, 1e-3);
  EXPECT_NEAR(surfaceArea(sliding.mesh), 1.0, 1e-12); // the outline is still the square
  EXPECT_NEAR(surfaceArea(fixed.mesh), 1.0, 1e-12);
}

TEST(SurfaceRedistribution, LengthEvensOutABoundary)
{
  SurfaceMesh input = shapes::tube(24, 4, 0.5, [](double) { return 1.0; });
  for (Vec3& p : input.points)
  {
    const double u = std::atan2(p.y(), p.x());
    p = Eigen::AngleAxisd(0.4 * std::sin(u), Vec3::UnitZ()) * p;
  }
  SurfaceRedistributionOptions options = only(0.0, 0.0, 1.0);
  options.numberOfSteps = 100;
  const auto result = redistributeSurface(input, options);
  const auto spread = [](const SurfaceMesh& mesh)
  {
    std::vector<double> lengths;
    for (std::size_t i = 0; i < 24; ++i)
    {
      lengths.push_back((mesh.points[(i + 1) % 24] - mesh.points[i]).norm());
    }
    return checks::relativeSpread(lengths);
  };
  EXPECT_LT(spread(result.mesh), 0.25 * spread(input));
}

TEST(SurfaceRedistribution, WithoutPreserveShapeTheSurfaceMayDrift)
{
  const SurfaceMesh input = crowdedSphere(2);
  SurfaceRedistributionOptions options;
  options.preserveShape = false;
  const auto result = redistributeSurface(input, options);
  EXPECT_GT(farthestFrom(input, result.mesh.points), 1e-3);
  EXPECT_LT(farthestFrom(input, result.mesh.points), 0.3);
}

TEST(SurfaceRedistribution, SurvivesSliversAndDegenerateFaces)
{
  SurfaceMesh input = shapes::shakenSheet(10, true, 0.3, 8);
  input.points[60] = input.points[61];
  input.points[38] = 0.999 * input.points[37] + 0.001 * input.points[38];
  const auto result = redistributeSurface(input, SurfaceRedistributionOptions());
  for (const Vec3& p : result.mesh.points)
  {
    EXPECT_TRUE(p.allFinite());
  }
  EXPECT_NEAR(surfaceArea(result.mesh), surfaceArea(input), 0.05);
}

TEST(SurfaceRedistribution, HasTheSameBitsForAnyNumberOfThreads)
{
  const SurfaceMesh input = crowdedSphere(5);
  SurfaceRedistributionOptions options;
  options.numberOfSteps = 2;
  const auto serial = redistributeSurface(input, options);
  for (const int threads : { 1, 2, 8 })
  {
    const auto result = redistributeSurface(input, options, threadedExecution(threads, 9));
    EXPECT_TRUE(result.mesh.points == serial.mesh.points) << threads << " threads";
  }
}

TEST(SurfaceRedistribution, RefusesWhatItCannotUse)
{
  SurfaceRedistributionOptions options;
  EXPECT_THROW(redistributeSurface(SurfaceMesh(), options), InputError);
  options.timeStep = 0.0;
  EXPECT_THROW(redistributeSurface(icosphere(1), options), InputError);
  options = {};
  options.featureAngle = 181.0;
  EXPECT_THROW(redistributeSurface(icosphere(1), options), InputError);
  options = {};
  options.redistribution.angle = -1.0;
  EXPECT_THROW(redistributeSurface(icosphere(1), options), InputError);
  const Execution stopped(nullptr, nullptr, [] { return true; });
  EXPECT_THROW(redistributeSurface(icosphere(1), {}, stopped), Cancelled);
}
