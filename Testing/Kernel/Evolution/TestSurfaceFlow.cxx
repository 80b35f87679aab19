// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceFlow.h"

#include "Errors.h"
#include "Evolution/EvolutionShapes.h"
#include "Mesh/MeshTopology.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace evolving;

namespace
{

FlowOptions meanCurvatureFlow(double timeStep, int steps, double omega = 0.0)
{
  FlowOptions options;
  options.relativeUnits = false;
  options.timeStep = timeStep;
  options.numberOfSteps = steps;
  options.redistribution.volume = omega;
  return options;
}

/// e of (6.1) as METHOD settles it, over the whole run of a shrinking unit sphere.
double shrinkingSphereError(const SurfaceMesh& start, double tau, int steps, double omega)
{
  SurfaceFlow flow(start, nullptr, meanCurvatureFlow(tau, steps, omega));
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

void run(SurfaceFlow& flow)
{
  while (!flow.isFinished())
  {
    flow.step();
  }
}

/// Towards a sphere of radius 0.5 from a bumpy one around it.
FlowOptions towardsSphere(int steps)
{
  FlowOptions options;
  options.timeStep = 0.05;
  options.numberOfSteps = steps;
  options.curvatureSpeed = 0.1;
  options.advectionSpeed = 1.0;
  options.redistribution.volume = 1.0;
  return options;
}

double largestRadialError(const SurfaceMesh& mesh, double radius)
{
  double worst = 0.0;
  for (const Vec3& p : mesh.points)
  {
    worst = std::max(worst, std::abs(p.norm() - radius));
  }
  return worst;
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

class ShrinkingSphere : public ::testing::TestWithParam<SphereRow>
{
};

TEST_P(ShrinkingSphere, ReproducesTheTable)
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

INSTANTIATE_TEST_SUITE_P(Levels, ShrinkingSphere,
  ::testing::Values(SphereRow{ 1, 0.01, 6, 0.00306693, 0.00306683, 0.00306683, 0.00306683 },
    SphereRow{ 2, 0.0025, 24, 0.000867587, 0.000867625, 0.000872717, 0.00100435 },
    SphereRow{ 3, 0.000625, 96, 0.000210629, 0.000210625, 0.000211283, 0.000226696 },
    SphereRow{ 4, 0.00015625, 384, 0.0000511243, 0.0000511173, 0.0000511856, 0.0000536707 }));

TEST(SurfaceFlow, ShrinksACubeSphereOfQuads)
{
  EXPECT_NEAR(shrinkingSphereError(cubeSphere(3), 0.01, 6, 0.0), 0.0027455, 5e-3 * 0.0027455);
  EXPECT_NEAR(shrinkingSphereError(cubeSphere(6), 0.0025, 24, 0.0), 0.00067973, 5e-3 * 0.00067973);
  EXPECT_NEAR(
    shrinkingSphereError(cubeSphere(12), 0.000625, 96, 0.0), 0.00016542, 5e-3 * 0.00016542);
}

TEST(SurfaceFlow, AreaFallsInEveryStepOfMeanCurvatureFlow)
{
  for (const SurfaceMesh& start :
    { shapes::bumpySphere(3), cubeSphere(8), shapes::torusGrid(24, 12, 1.0, 0.4, true) })
  {
    SurfaceFlow flow(start, nullptr, meanCurvatureFlow(0.002, 30, 1.0));
    double area = flow.record().area;
    while (!flow.isFinished())
    {
      flow.step();
      EXPECT_LT(flow.record().area, area);
      area = flow.record().area;
    }
    EXPECT_EQ(flow.record().iteration, 30);
  }
}

TEST(SurfaceFlow, NestedSurfacesStayNested)
{
  // The comparison principle: an ellipsoid between two spheres.
  SurfaceFlow flow(
    shapes::ellipsoid(3, Vec3(1.0, 0.8, 0.7)), nullptr, meanCurvatureFlow(0.002, 50));
  while (!flow.isFinished())
  {
    flow.step();
    const double t = flow.record().time;
    for (const Vec3& p : flow.mesh().points)
    {
      EXPECT_LT(p.norm(), std::sqrt(1.0 - 4.0 * t) + 5e-3);
      EXPECT_GT(p.norm(), std::sqrt(0.49 - 4.0 * t) - 5e-3);
    }
  }
}

TEST(SurfaceFlow, AnEllipsoidGetsRounder)
{
  SurfaceFlow flow(
    shapes::ellipsoid(3, Vec3(1.3, 1.0, 0.8)), nullptr, meanCurvatureFlow(0.002, 60, 1.0));
  const auto ratio = [&]()
  {
    const Vec3 sides = boundingBox(flow.mesh()).diagonal();
    return sides.maxCoeff() / sides.minCoeff();
  };
  const double before = ratio();
  run(flow);
  EXPECT_LT(ratio() - 1.0, 0.8 * (before - 1.0));
}

TEST(SurfaceFlow, ConvergesToTheCatenoid)
{
  // Between two circles of radius cosh(0.5) at z = +-0.5: r(z) = cosh z.
  double last = 0.0;
  for (const Index n : { 6, 12 })
  {
    const SurfaceMesh start =
      shapes::tube(6 * n, 2 * n, 0.5, [](double) { return std::cosh(0.5); });
    SurfaceFlow flow(start, nullptr, meanCurvatureFlow(0.05, 60));
    run(flow);
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

TEST(SurfaceFlow, ABumpOnADiscFlattens)
{
  SurfaceMesh start = shapes::sheet(10, false);
  for (Vec3& p : start.points)
  {
    p.z() = 0.2 * std::sin(shapes::Pi * p.x()) * std::sin(shapes::Pi * p.y());
  }
  SurfaceFlow flow(start, nullptr, meanCurvatureFlow(0.05, 40));
  run(flow);
  EXPECT_NEAR(flow.record().area, 1.0, 1e-9);
  for (const Vec3& p : flow.mesh().points)
  {
    EXPECT_NEAR(p.z(), 0.0, 1e-6);
  }
}

TEST(SurfaceFlow, AFreeBoundaryShrinksAndASlidingOneKeepsItsShape)
{
  const SurfaceMesh start = shapes::shakenSheet(8, true, 0.3, 12);
  FlowOptions options = meanCurvatureFlow(0.001, 10, 1.0);
  options.boundaryMode = BoundaryMode::Free;
  SurfaceFlow free(start, nullptr, options);
  run(free);
  EXPECT_LT(free.record().area, 0.99);
  options.boundaryMode = BoundaryMode::SlideAlong;
  options.timeStep = 0.1;
  SurfaceFlow sliding(start, nullptr, options);
  run(sliding);
  EXPECT_EQ(sliding.stopReason(), "");
  EXPECT_NEAR(sliding.record().area, 1.0, 1e-12);
  EXPECT_GT((sliding.mesh().points[3] - start.points[3]).norm(), 1e-3);
  EXPECT_EQ(sliding.mesh().points[0], start.points[0]);
}

TEST(SurfaceFlow, ReachesASphereFromOutsideAndFromInside)
{
  const auto field = shapes::sphereField(61, 1.6, 0.5);
  for (const double size : { 1.0, 0.2 })
  {
    SurfaceFlow flow(shapes::transformed(shapes::bumpySphere(3), size, Vec3(0.02, 0.0, 0.05)),
      field, towardsSphere(150));
    run(flow);
    EXPECT_EQ(flow.stopReason(), "");
    EXPECT_LT(largestRadialError(flow.mesh(), 0.5), 0.01);
    EXPECT_LT(flow.record().maxDistance, 0.01);
    EXPECT_GT(flow.record().minAngle, 25.0);
    EXPECT_NEAR(flow.lengthUnit(), 0.5 * std::sqrt(3.0), 0.05);
  }
}

TEST(SurfaceFlow, DistanceFallsAsAdvectionSays)
{
  // Without curvature motion d' = -C d: after T the surface is e^(-C T) of its distance away.
  const auto field = shapes::sphereField(81, 1.2, 0.4);
  FlowOptions options = towardsSphere(200);
  options.timeStep = 0.01;
  options.curvatureSpeed = 0.0;
  SurfaceFlow flow(icosphere(3), field, options);
  run(flow);
  EXPECT_NEAR(flow.record().meanDistance, 0.6 * std::exp(-2.0), 2e-3);
}

TEST(SurfaceFlow, LongStepsAreDividedInside)
{
  const auto field = shapes::sphereField(61, 1.6, 0.5);
  FlowOptions options = towardsSphere(4);
  options.timeStep = 2.5;
  options.advectionSpeed = 4.0; // tau C = 10
  options.redistribution.volume = 1e4;
  options.redistribution.angle = 3.0;
  SurfaceFlow flow(shapes::bumpySphere(2), field, options);
  run(flow);
  EXPECT_EQ(flow.stopReason(), "");
  EXPECT_EQ(flow.record().iteration, 4);
  EXPECT_NEAR(flow.record().time, 10.0, 1e-12);
  EXPECT_LT(largestRadialError(flow.mesh(), 0.5), 0.02);
}

TEST(SurfaceFlow, VolumeRedistributionEvensOutCoVolumes)
{
  SurfaceMesh start = icosphere(3);
  for (Vec3& p : start.points)
  {
    p = (p + Vec3(0, 0, 0.5)).normalized(); // crowded at the top
  }
  const auto field = shapes::sphereField(41, 1.6, 1.0);
  FlowOptions options = towardsSphere(100);
  SurfaceFlow with(start, field, options);
  const double before = shapes::relativeSpread(with.arrays().coVolume);
  run(with);
  EXPECT_GT(before, 0.4);
  EXPECT_LT(shapes::relativeSpread(with.arrays().coVolume), 0.05);
  options.redistribution.volume = 0.0;
  SurfaceFlow without(start, field, options);
  run(without);
  EXPECT_GT(shapes::relativeSpread(without.arrays().coVolume), 0.8 * before);
}

TEST(SurfaceFlow, FollowsTranslationsAndScale)
{
  const Vec3 offset(1000.0, -500.0, 250.0);
  const double scale = 8.0; // a power of two: the same rounding
  const SurfaceMesh start = shapes::bumpySphere(2);
  const auto field = shapes::sphereField(31, 1.6, 0.5);
  DistanceGrid moved = field->grid();
  moved.origin = scale * moved.origin + offset;
  moved.spacing *= scale;
  std::vector<float> values = field->values();
  for (float& value : values)
  {
    value *= static_cast<float>(scale);
  }
  SurfaceFlow flow(start, field, towardsSphere(20));
  SurfaceFlow other(shapes::transformed(start, scale, offset),
    std::make_shared<const ScalarImage>(moved, values), towardsSphere(20));
  run(flow);
  run(other);
  for (std::size_t i = 0; i < start.points.size(); ++i)
  {
    const Vec3 expected = scale * flow.mesh().points[i] + offset;
    EXPECT_LT((other.mesh().points[i] - expected).norm(), 1e-6 * scale);
  }
}

TEST(SurfaceFlow, ComponentsEvolveAsIfAlone)
{
  const SurfaceMesh first = shapes::bumpySphere(2);
  const SurfaceMesh second = shapes::ellipsoid(2, Vec3(0.5, 0.7, 0.6));
  const FlowOptions options = meanCurvatureFlow(0.002, 15, 2.0);
  SurfaceFlow alone(first, nullptr, options);
  SurfaceFlow both(
    shapes::together(first, shapes::transformed(second, 1.0, Vec3(4, 0, 0))), nullptr, options);
  run(alone);
  run(both);
  for (std::size_t i = 0; i < first.points.size(); ++i)
  {
    EXPECT_LT((alone.mesh().points[i] - both.mesh().points[i]).norm(), 1e-8);
  }
}

TEST(SurfaceFlow, SmoothingRemovesRoughnessAfterTheEvolution)
{
  SurfaceMesh start = icosphere(3, 0.5);
  for (std::size_t i = 0; i < start.points.size(); ++i)
  {
    start.points[i] *= 1.0 + (i % 2 == 0 ? 0.02 : -0.02);
  }
  const auto field = shapes::sphereField(41, 1.0, 0.5);
  FlowOptions options = towardsSphere(0);
  options.smoothingSteps = 5;
  options.smoothingSpeed = 0.05;
  options.smoothingDecay = 0.5;
  SurfaceFlow flow(start, field, options);
  EXPECT_EQ(flow.totalSteps(), 5);
  double area = flow.record().area;
  std::vector<double> losses;
  while (!flow.isFinished())
  {
    flow.step();
    losses.push_back(area - flow.record().area);
    area = flow.record().area;
  }
  ASSERT_EQ(losses.size(), 5u);
  EXPECT_GT(losses[0], 2.0 * losses[4]);
  EXPECT_GT(flow.record().meanDistance, 0.0);
}

TEST(SurfaceFlow, EndsWhenNothingMovesAnyMore)
{
  const auto field = shapes::sphereField(61, 1.6, 0.5);
  FlowOptions options = towardsSphere(2000);
  options.timeStep = 0.2;
  options.convergenceTolerance = 1e-4;
  SurfaceFlow flow(shapes::bumpySphere(2), field, options);
  run(flow);
  EXPECT_TRUE(flow.hasConverged());
  EXPECT_EQ(flow.stopReason(), "");
  EXPECT_LT(flow.record().iteration, 500);
  // With smoothing steps the state waits for them.
  options.numberOfSteps = 200;
  options.smoothingSteps = 2;
  options.smoothingSpeed = 0.001;
  SurfaceFlow smoothed(shapes::bumpySphere(2), field, options);
  double areaWhenConverged = 0.0;
  while (!smoothed.isFinished())
  {
    smoothed.step();
    if (smoothed.hasConverged() && smoothed.record().iteration < 200)
    {
      EXPECT_TRUE(areaWhenConverged == 0.0 || areaWhenConverged == smoothed.record().area);
      areaWhenConverged = smoothed.record().area;
    }
  }
  EXPECT_EQ(smoothed.record().iteration, 202);
  EXPECT_LT(smoothed.record().area, areaWhenConverged);
}

TEST(SurfaceFlow, TheEdgeOfABallInAnImageAttractsASurface)
{
  const auto ball = shapes::image(shapes::cubicGrid(61, 1.5),
    [](const Vec3& p) { return 1.0 / (1.0 + std::exp((p.norm() - 0.6) / 0.05)); });
  FlowOptions options;
  options.relativeUnits = false;
  options.fieldMode = FieldMode::EdgeDetector;
  options.edgeSharpness = 2.0;
  options.curvatureSpeed = 0.05;
  options.advectionSpeed = 0.05;
  options.timeStep = 0.05;
  options.numberOfSteps = 150;
  const auto radiusAtTheEnd = [&](double start)
  {
    SurfaceFlow flow(icosphere(2, start), ball, options);
    run(flow);
    EXPECT_EQ(flow.stopReason(), "");
    EXPECT_LT(largestRadialError(flow.mesh(), flow.mesh().points[0].norm()), 0.02);
    return flow.mesh().points[0].norm();
  };
  // -2 b e / r - a de/dr = 0 at r = 0.5913, just inside the edge at 0.6.
  EXPECT_NEAR(radiusAtTheEnd(1.0), 0.5913, 0.015);
  options.curvatureSpeed = 0.0005;
  EXPECT_NEAR(radiusAtTheEnd(0.45), 0.6, 0.015); // from inside as well
  options.advectionSpeed = 0.0;
  EXPECT_LT(radiusAtTheEnd(0.45), 0.45);
}

TEST(SurfaceFlow, EverythingIsAvailableForTheStart)
{
  const SurfaceMesh start = shapes::bumpySphere(2);
  FlowOptions options = towardsSphere(3);
  const SurfaceFlow flow(start, shapes::sphereField(31, 1.6, 0.5), options);
  const FlowArrays& arrays = flow.arrays();
  EXPECT_EQ(flow.record().iteration, 0);
  EXPECT_EQ(flow.record().time, 0.0);
  EXPECT_NEAR(flow.record().area, surfaceArea(start), 1e-12);
  EXPECT_NEAR(flow.record().volume, signedVolume(start), 1e-12);
  EXPECT_GT(flow.record().minAngle, 10.0);
  EXPECT_GT(flow.record().meanDistance, 0.3);
  EXPECT_TRUE(flow.mesh().points == start.points);
  for (const std::size_t size :
    { arrays.distance.size(), arrays.distanceGradient.size(), arrays.normal.size(),
      arrays.meanCurvature.size(), arrays.coVolume.size(), arrays.normalVelocity.size(),
      arrays.tangentialVelocity.size(), arrays.redistributionPotential.size() })
  {
    EXPECT_EQ(size, start.points.size());
  }
}

TEST(SurfaceFlow, RegularIcosahedronOnlyShrinks)
{
  SurfaceFlow flow(icosphere(0), nullptr, meanCurvatureFlow(0.01, 5, 50.0));
  run(flow);
  const double radius = flow.mesh().points[0].norm();
  EXPECT_LT(radius, 0.95);
  for (std::size_t i = 0; i < 12; ++i)
  {
    EXPECT_LT((flow.mesh().points[i] - radius * icosphere(0).points[i]).norm(), 1e-9);
  }
}

TEST(SurfaceFlow, StopsWhenTheSurfaceVanishes)
{
  SurfaceFlow flow(icosphere(2), nullptr, meanCurvatureFlow(0.02, 100, 1.0));
  run(flow);
  EXPECT_NE(flow.stopReason().find("shrunk"), std::string::npos) << flow.stopReason();
  EXPECT_LT(flow.record().iteration, 30);
  EXPECT_GE(flow.record().iteration, 12); // extinction at t = 1/4
  for (const Vec3& p : flow.mesh().points)
  {
    EXPECT_TRUE(p.allFinite());
  }
  EXPECT_EQ(static_cast<Index>(flow.arrays().coVolume.size()), 162);
}

TEST(SurfaceFlow, StopsAtTheGuardWithTheLastGoodState)
{
  // Without curvature motion nothing pulls points back that leave a sphere along its tangents.
  SurfaceMesh start = icosphere(2);
  for (Vec3& p : start.points)
  {
    p = (p + Vec3(0, 0, 0.4)).normalized();
  }
  FlowOptions options = meanCurvatureFlow(0.1, 100, 5.0);
  options.curvatureSpeed = 0.0;
  options.surfaceGuard = 1.0;
  SurfaceFlow flow(start, nullptr, options);
  run(flow);
  EXPECT_NE(flow.stopReason().find("bounding box"), std::string::npos) << flow.stopReason();
  EXPECT_LT(flow.record().iteration, 100);
  const Box box = boundingBox(start);
  for (const Vec3& p : flow.mesh().points)
  {
    EXPECT_LT(box.exteriorDistance(p), 1e-8);
  }
}

TEST(SurfaceFlow, AnyParametersEndInAFiniteSurface)
{
  std::mt19937 random(2020);
  const auto logarithmic = [&](double low, double high)
  {
    std::uniform_real_distribution<double> exponent(std::log(low), std::log(high));
    return std::exp(exponent(random));
  };
  const auto field = shapes::sphereField(21, 1.6, 0.5);
  const std::vector<SurfaceMesh> starts = { shapes::bumpySphere(1), cubeSphere(3),
    shapes::shakenSheet(4, true, 0.4, 1), shapes::torusGrid(8, 6, 1.0, 0.4, false) };
  for (int trial = 0; trial < 60; ++trial)
  {
    FlowOptions options;
    options.timeStep = logarithmic(1e-6, 1e4);
    options.numberOfSteps = 5;
    options.curvatureSpeed = random() % 4 ? logarithmic(1e-8, 1e4) : 0.0;
    options.curvatureRange = logarithmic(1e-6, 1e4);
    options.advectionSpeed = random() % 4 ? logarithmic(1e-6, 1e6) : 0.0;
    options.advectionBalance = 0.5 * static_cast<double>(random() % 3);
    options.fieldMode = static_cast<FieldMode>(random() % 2);
    options.edgeSharpness = random() % 2 ? logarithmic(1e-3, 1e3) : 0.0;
    options.unsignedField = random() % 2;
    options.redistribution.volume = random() % 2 ? logarithmic(1e-3, 1e6) : 0.0;
    options.redistribution.angle = random() % 2 ? logarithmic(1e-3, 1e6) : 0.0;
    options.redistribution.length = random() % 2 ? logarithmic(1e-3, 1e6) : 0.0;
    options.redistribution.angleWeighting = static_cast<AngleWeighting>(random() % 3);
    options.redistribution.curvatureControl = static_cast<CurvatureControl>(random() % 4);
    options.boundaryMode = static_cast<BoundaryMode>(random() % 3);
    options.smoothingSteps = static_cast<int>(random() % 3);
    options.smoothingSpeed = logarithmic(1e-6, 1e2);
    options.relativeUnits = random() % 2;
    SurfaceFlow flow(starts[random() % 4], random() % 4 ? field : nullptr, options);
    run(flow);
    EXPECT_TRUE(!flow.stopReason().empty() || flow.record().iteration == flow.totalSteps());
    for (const Vec3& p : flow.mesh().points)
    {
      ASSERT_TRUE(p.allFinite()) << "trial " << trial;
    }
    for (const Vec3& v : flow.arrays().tangentialVelocity)
    {
      ASSERT_TRUE(v.allFinite()) << "trial " << trial;
    }
    ASSERT_TRUE(std::isfinite(flow.record().area + flow.record().volume + flow.record().minAngle));
  }
}

TEST(SurfaceFlow, ResumesFromAState)
{
  const auto field = shapes::sphereField(31, 1.6, 0.5);
  SurfaceFlow flow(shapes::bumpySphere(2), field, towardsSphere(10));
  FlowState middle;
  while (!flow.isFinished())
  {
    flow.step();
    middle = flow.record().iteration == 4 ? flow.state() : middle;
  }
  SurfaceFlow again(shapes::bumpySphere(2), field, towardsSphere(10));
  again.resume(middle);
  EXPECT_EQ(again.record().iteration, 4);
  run(again);
  EXPECT_EQ(again.record().iteration, 10);
  for (std::size_t i = 0; i < middle.points.size(); ++i)
  {
    EXPECT_LT((again.mesh().points[i] - flow.mesh().points[i]).norm(), 1e-8);
  }
}

TEST(SurfaceFlow, HasTheSameBitsForAnyNumberOfThreads)
{
  const auto field = shapes::sphereField(31, 1.6, 0.5);
  FlowOptions options = towardsSphere(2);
  options.redistribution.angle = 1.0;
  options.redistribution.length = 1.0;
  options.redistribution.curvatureControl = CurvatureControl::CubeRoot;
  const SurfaceMesh start = shapes::bumpySphere(5); // 10242 vertices
  SurfaceFlow serial(start, field, options);
  run(serial);
  for (const int threads : { 1, 2, 8 })
  {
    SurfaceFlow flow(start, field, options, threadedExecution(threads, 5));
    run(flow);
    EXPECT_TRUE(flow.mesh().points == serial.mesh().points) << threads << " threads";
    EXPECT_EQ(flow.arrays().redistributionPotential, serial.arrays().redistributionPotential);
    EXPECT_EQ(flow.record().area, serial.record().area);
    EXPECT_EQ(flow.record().solverIterations, serial.record().solverIterations);
  }
}

TEST(SurfaceFlow, ReportsProgressAndStopsOnRequest)
{
  std::vector<double> fractions;
  bool stop = false;
  const Execution execution(
    nullptr, [&](double fraction) { fractions.push_back(fraction); }, [&] { return stop; });
  SurfaceFlow flow(shapes::bumpySphere(3), nullptr, meanCurvatureFlow(0.002, 10, 1.0), execution);
  for (int k = 0; k < 5; ++k)
  {
    flow.step();
  }
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_GT(fractions.back(), 0.4);
  EXPECT_LE(fractions.back(), 0.5);
  const std::vector<Vec3> before = flow.mesh().points;
  stop = true;
  EXPECT_THROW(flow.step(), Cancelled);
  EXPECT_TRUE(flow.mesh().points == before);
  EXPECT_EQ(flow.record().iteration, 5);
  stop = false;
  run(flow);
  EXPECT_EQ(flow.record().iteration, 10);
}

TEST(SurfaceFlow, UnusedPointsStay)
{
  SurfaceMesh start = shapes::bumpySphere(2);
  start.addPoint(Vec3(0.1, 0.2, 0.3));
  SurfaceFlow flow(start, nullptr, meanCurvatureFlow(0.002, 5, 1.0));
  run(flow);
  EXPECT_EQ(flow.record().iteration, 5);
  EXPECT_EQ(flow.mesh().points.back(), Vec3(0.1, 0.2, 0.3));
}

TEST(SurfaceFlow, SurvivesDegenerateFaces)
{
  SurfaceMesh start = shapes::bumpySphere(2);
  const MeshTopology topology(start);
  // One vertex onto its neighbour, another onto the middle of an edge of its ring.
  start.points[50] = start.points[static_cast<std::size_t>(topology.ringVertices(50)[0])];
  const MeshTopology::Run ring = topology.ringVertices(90);
  start.points[90] = 0.5 *
    (start.points[static_cast<std::size_t>(ring[0])] +
      start.points[static_cast<std::size_t>(ring[1])]);
  SurfaceFlow flow(start, shapes::sphereField(31, 1.6, 0.5), towardsSphere(60));
  run(flow);
  EXPECT_EQ(flow.stopReason(), "");
  EXPECT_LT(largestRadialError(flow.mesh(), 0.5), 0.05);
}

TEST(SurfaceFlow, RefusesWhatItCannotUse)
{
  const auto make = [](SurfaceMesh mesh, const FlowOptions& options = FlowOptions())
  { SurfaceFlow flow(std::move(mesh), nullptr, options); };
  EXPECT_THROW(make(SurfaceMesh()), InputError);
  SurfaceMesh points;
  points.addPoint(Vec3::Zero());
  EXPECT_THROW(make(points), InputError);
  SurfaceMesh bad = icosphere(1);
  bad.points[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(make(bad), InputError);
  EXPECT_THROW(make(shapes::transformed(icosphere(1), 0.0, Vec3::Zero())), InputError);
  SurfaceMesh fin = icosphere(1);
  const Index tip = fin.addPoint(Vec3(2, 2, 2));
  fin.addFace({ fin.faceVertex(0, 0), fin.faceVertex(0, 1), tip });
  EXPECT_THROW(make(fin), InputError);
  FlowOptions options;
  options.timeStep = -1.0;
  EXPECT_THROW(make(icosphere(1), options), InputError);
}
