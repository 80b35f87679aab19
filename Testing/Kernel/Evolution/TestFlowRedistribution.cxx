// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// What each kind of redistribution does during a flow, beside the same flow without it.

#include "Evolution/SurfaceFlow.h"

#include "Checks/SurfaceMeasures.h"
#include "Evolution/EvolutionFields.h"
#include "Evolution/FlowRuns.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/MixedPolygons.h"
#include "Shapes/SampledOnGrid.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace evolving;

namespace
{

/// Figure 6.2: mean curvature flow of the uneven sphere, down to 0.7 of its radius.
SurfaceFlow figure62(double volume, double angle)
{
  FlowOptions options = flows::meanCurvatureFlow(0.005, 25, volume);
  options.redistribution.angle = angle;
  SurfaceFlow flow(shapes::unevenSphere(3), nullptr, options);
  flows::run(flow);
  EXPECT_EQ(flow.stopReason(), "");
  EXPECT_EQ(flow.record().iteration, 25);
  return flow;
}

double areaSpread(const SurfaceFlow& flow)
{
  return checks::relativeSpread(flow.arrays().coVolume);
}

/// About the distance from an ellipsoid about the origin.
std::shared_ptr<const ScalarImage> ellipsoidField(const Vec3& halfAxes)
{
  return shapes::image(shapes::cubicGrid(61, 2.5),
    [=](const Vec3& p)
    {
      const double level = p.cwiseQuotient(halfAxes).norm();
      const double slope = p.cwiseQuotient(halfAxes.cwiseAbs2()).norm();
      return level > 0.0 ? (level - 1.0) * level / slope : -halfAxes.minCoeff();
    });
}

/// Mean co-volume around the waist over that at the tips of an ellipsoid along x, at rest in its
/// field but for redistribution.
double waistToTip(CurvatureControl control)
{
  const Vec3 halfAxes(2.0, 1.0, 1.0);
  FlowOptions options = flows::towardsSphere(100);
  options.curvatureSpeed = 0.0;
  options.redistribution.curvatureControl = control;
  SurfaceFlow flow(shapes::ellipsoid(3, halfAxes), ellipsoidField(halfAxes), options);
  flows::run(flow);
  EXPECT_EQ(flow.stopReason(), "");
  double area[2] = { 0.0, 0.0 };
  int count[2] = { 0, 0 };
  for (std::size_t i = 0; i < flow.mesh().points.size(); ++i)
  {
    const double x = std::abs(flow.mesh().points[i].x());
    if (x < 0.3 || x > 1.9)
    {
      area[x > 1.9] += flow.arrays().coVolume[i];
      ++count[x > 1.9];
    }
  }
  EXPECT_GT(count[1], 3);
  return area[0] / count[0] * count[1] / area[1];
}

/// A torus whose meridians crowd at one side.
SurfaceMesh crowdedTorus()
{
  SurfaceMesh mesh = shapes::quadTorus(20, 10, 2.0, 0.8);
  for (Vec3& p : mesh.points)
  {
    const double u = std::atan2(p.y(), p.x());
    p = Eigen::AngleAxisd(0.5 * std::sin(u), Vec3::UnitZ()) * p;
  }
  return mesh;
}

/// The spread of edge lengths along the outermost circle of that torus after a short flow.
double edgeSpread(double length)
{
  FlowOptions options = flows::meanCurvatureFlow(0.002, 90);
  options.redistribution.length = length;
  SurfaceFlow flow(crowdedTorus(), nullptr, options);
  flows::run(flow);
  EXPECT_EQ(flow.stopReason(), "");
  std::vector<double> lengths;
  for (std::size_t i = 0; i < 20; ++i)
  {
    const Vec3 edge = flow.mesh().points[(i + 1) % 20 * 10] - flow.mesh().points[i * 10];
    lengths.push_back(edge.norm());
  }
  return checks::relativeSpread(lengths);
}

} // namespace

TEST(FlowRedistribution, VolumeEvensOutTheSphereOfFigure62)
{
  const SurfaceFlow start(shapes::unevenSphere(3), nullptr, flows::meanCurvatureFlow(0.005, 0));
  EXPECT_GT(areaSpread(start), 0.5);
  EXPECT_GT(areaSpread(figure62(0.0, 0.0)), 0.5);
  EXPECT_GT(areaSpread(figure62(0.0, 3.0)), 0.5); // angles are not areas
  EXPECT_LT(areaSpread(figure62(200.0, 0.0)), 0.05);
  EXPECT_LT(areaSpread(figure62(200.0, 3.0)), 0.05);
}

TEST(FlowRedistribution, AngleWidensTheAnglesOfTheSphereOfFigure62)
{
  EXPECT_LT(figure62(0.0, 0.0).record().minAngle, 25.0);
  EXPECT_LT(figure62(200.0, 0.0).record().minAngle, 25.0);
  EXPECT_GT(figure62(0.0, 3.0).record().minAngle, 33.0);
  EXPECT_GT(figure62(200.0, 3.0).record().minAngle, 33.0);
}

TEST(FlowRedistribution, LengthEvensOutTheEdgesAroundATorus)
{
  EXPECT_GT(edgeSpread(0.0), 0.3);
  EXPECT_LT(edgeSpread(20.0), 0.1);
}

TEST(FlowRedistribution, CurvatureControlMakesTipsFinerDuringAFlow)
{
  // Mean curvature is 4 at the tips and 1.25 around the waist.
  EXPECT_NEAR(waistToTip(CurvatureControl::None), 1.0, 0.1);
  EXPECT_NEAR(waistToTip(CurvatureControl::CubeRoot), std::cbrt(4.0 / 1.25), 0.25);
  EXPECT_NEAR(waistToTip(CurvatureControl::TwoThirds), std::pow(4.0 / 1.25, 2.0 / 3.0), 0.4);
}

TEST(FlowRedistribution, VolumeEvensOutCoVolumesOnTheTarget)
{
  SurfaceMesh start = icosphere(3);
  for (Vec3& p : start.points)
  {
    p = (p + Vec3(0, 0, 0.5)).normalized(); // crowded at the top
  }
  const auto field = shapes::sphereField(41, 1.6, 1.0);
  FlowOptions options = flows::towardsSphere(100);
  SurfaceFlow with(start, field, options);
  const double before = areaSpread(with);
  flows::run(with);
  EXPECT_GT(before, 0.4);
  EXPECT_LT(areaSpread(with), 0.05);
  options.redistribution.volume = 0.0;
  SurfaceFlow without(start, field, options);
  flows::run(without);
  EXPECT_GT(areaSpread(without), 0.8 * before);
}

TEST(FlowRedistribution, EveryComponentIsEvenByItself)
{
  // A factor of 100 between the areas: one mean for both would tear at the small one.
  const SurfaceMesh big = shapes::unevenSphere(3);
  const SurfaceMesh small = shapes::transformed(shapes::unevenSphere(2), 0.1, Vec3(3.0, 0.0, 0.0));
  FlowOptions options = flows::meanCurvatureFlow(1e-5, 50, 2e4);
  SurfaceFlow flow(shapes::merged(big, small), nullptr, options);
  flows::run(flow);
  EXPECT_EQ(flow.stopReason(), "");
  const std::vector<double>& mu = flow.arrays().coVolume;
  const auto middle = mu.begin() + big.vertexCount();
  EXPECT_LT(checks::relativeSpread({ mu.begin(), middle }), 0.05);
  EXPECT_LT(checks::relativeSpread({ middle, mu.end() }), 0.05);
}

TEST(FlowRedistribution, AngleWeightsActDuringAFlow)
{
  FlowOptions options = flows::towardsSphere(0);
  options.redistribution.volume = 0.0;
  options.redistribution.angle = 0.1;
  const auto start = [&](AngleWeighting weighting)
  {
    options.redistribution.angleWeighting = weighting;
    return SurfaceFlow(shapes::unevenSphere(3), shapes::sphereField(41, 1.6, 0.5), options);
  };
  const SurfaceFlow plain = start(AngleWeighting::None);
  const SurfaceFlow byArea = start(AngleWeighting::InverseArea);
  const SurfaceFlow byDistance = start(AngleWeighting::Distance);
  const double mean = plain.record().area / 642.0;
  for (std::size_t i = 0; i < 642; ++i)
  {
    const Vec3& v = plain.arrays().tangentialVelocity[i];
    const double area = std::min(1.0, mean / plain.arrays().coVolume[i]);
    EXPECT_LT((byArea.arrays().tangentialVelocity[i] - area * v).norm(), 1e-14);
    const double distance = plain.arrays().distance[i] / plain.lengthUnit();
    EXPECT_LT((byDistance.arrays().tangentialVelocity[i] - distance * v).norm(), 1e-14);
    EXPECT_LT(distance, 0.65); // 0.5 / (0.5 sqrt(3)): not one
  }
}

TEST(FlowRedistribution, VelocitiesAreTangentialInEveryStep)
{
  FlowOptions options = flows::towardsSphere(20);
  options.redistribution.angle = 1.0;
  options.redistribution.length = 1.0;
  for (const SurfaceMesh& start : { shapes::bumpySphere(3), shapes::mixedSphere(3) })
  {
    SurfaceFlow flow(start, shapes::sphereField(31, 1.6, 0.5), options);
    while (!flow.isFinished())
    {
      flow.step();
      double fastest = 0.0;
      for (std::size_t i = 0; i < start.points.size(); ++i)
      {
        const Vec3& v = flow.arrays().tangentialVelocity[i];
        EXPECT_LE(std::abs(v.dot(flow.arrays().normal[i])), 1e-14);
        fastest = std::max(fastest, v.norm());
      }
      EXPECT_GT(fastest, 1e-4);
    }
  }
}

TEST(FlowRedistribution, GoesOnWithoutAPotential)
{
  const SurfaceMesh start = shapes::unevenSphere(3);
  const FlowOptions options = flows::meanCurvatureFlow(1e-3, 5, 1.0);
  SurfaceFlow flow(start, nullptr, options);
  EXPECT_TRUE(flow.record().isRedistributed);
  flow.step();
  FlowState state = flow.state();
  state.record.isRedistributed = false; // as where none could be solved for
  SurfaceFlow without(start, nullptr, options);
  without.resume(state);
  while (!without.isFinished())
  {
    EXPECT_FALSE(without.record().isRedistributed);
    for (std::size_t i = 0; i < start.points.size(); ++i)
    {
      EXPECT_EQ(without.arrays().redistributionPotential[i], 0.0);
      EXPECT_EQ(without.arrays().tangentialVelocity[i], Vec3::Zero());
    }
    without.step();
  }
  EXPECT_EQ(without.stopReason(), "");
}
