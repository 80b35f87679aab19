// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceFlow.h"

#include "Evolution/FlowRuns.h"
#include "Evolution/NoisyImages.h"
#include "Evolution/SurfaceRemesher.h"
#include "Shapes/MeshVariants.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

using namespace evolving;

namespace
{

/// As those of the filter are by default, but for the number of steps.
FlowOptions imageOptions()
{
  FlowOptions options;
  options.timeStep = 0.0;
  options.numberOfSteps = 150;
  options.curvatureSpeed = 0.1;
  options.fieldMode = FieldMode::Image;
  options.convergenceTolerance = 1e-3;
  return options;
}

SurfaceFlow segmented(
  const SurfaceMesh& start, std::shared_ptr<const ScalarImage> image, const FlowOptions& options)
{
  const auto shared = std::make_shared<const SurfaceMesh>(start);
  SurfaceRemeshingOptions remeshing;
  remeshing.onlyDegenerate = true;
  SurfaceFlow flow(
    shared, std::move(image), std::make_shared<SurfaceRemesher>(*shared, remeshing), options);
  flows::run(flow);
  EXPECT_EQ(flow.stopReason(), "");
  EXPECT_GT(flow.record().minAngle, 20.0);
  return flow;
}

struct Distances
{
  double mean = 0.0;
  double rms = 0.0;
  double largest = 0.0;
};

Distances distancesOf(const SurfaceMesh& mesh, const std::function<double(const Vec3&)>& distance)
{
  Distances d;
  for (const Vec3& p : mesh.points)
  {
    d.mean += distance(p) / double(mesh.points.size());
    d.rms += std::pow(distance(p), 2.0) / double(mesh.points.size());
    d.largest = std::max(d.largest, std::abs(distance(p)));
  }
  d.rms = std::sqrt(d.rms);
  return d;
}

/// Of an ellipsoid of half axes 22, 14, 10; exact to first order.
double fromEllipsoid(const Vec3& p)
{
  const Vec3 axes(22.0, 14.0, 10.0);
  const double level = std::max(1e-9, p.cwiseQuotient(axes).norm());
  const double slope = p.cwiseQuotient(axes.cwiseProduct(axes)).norm() / level;
  return (level - 1.0) / std::max(1e-9, slope);
}

/// Of two balls of radius 11 and a neck of radius 6 between their centers.
double fromDumbbell(const Vec3& p)
{
  const double balls = Vec3(std::abs(p.x()) - 18.0, p.y(), p.z()).norm() - 11.0;
  const double neck = std::max(p.tail<2>().norm() - 6.0, std::abs(p.x()) - 18.0);
  return std::min(balls, neck);
}

} // namespace

/// Radius, noise by the contrast.
class NoisyBall : public ::testing::TestWithParam<std::tuple<double, double>>
{
};

TEST_P(NoisyBall, IsFoundFromOutsideAndFromInside)
{
  const auto [radius, noise] = GetParam();
  const auto ball = shapes::ballOf(radius);
  const auto image = shapes::noisyImage(
    shapes::voxels(static_cast<int>(2.0 * radius) + 15), ball, noise, { 400.0, -1000.0 });
  const auto check = [&](double start, double speed)
  {
    FlowOptions options = imageOptions();
    options.normalSpeed = speed;
    const SurfaceFlow flow =
      segmented(shapes::transformed(icosphere(3, start), 1.0, Vec3(0.4, 0, -0.3)), image, options);
    EXPECT_TRUE(flow.hasConverged());
    const Distances d = distancesOf(flow.mesh(), ball);
    EXPECT_NEAR(d.mean, 0.0, 0.1) << start;
    EXPECT_LT(d.rms, 0.15) << start;
    EXPECT_LT(d.largest, 0.5) << start;
  };
  check(radius + 4.0, 0.0);  // from outside, by curvature
  check(radius + 4.0, -0.5); // with a push
  check(radius - 1.2, 0.0);  // from where the edge is felt
  check(2.0, 1.0);           // a seed
}

INSTANTIATE_TEST_SUITE_P(Segmentation, NoisyBall,
  ::testing::Combine(::testing::Values(5.0, 15.0), ::testing::Values(0.0, 0.1, 0.2)));

TEST(Segmentation, ASeedGrowsToAnEllipsoid)
{
  for (const double noise : { 0.0, 0.2 })
  {
    const auto image =
      shapes::noisyImage(shapes::voxels(53), fromEllipsoid, noise, { 60.0, -100.0 });
    FlowOptions options = imageOptions();
    options.normalSpeed = 1.0;
    const SurfaceFlow flow =
      segmented(shapes::transformed(icosphere(3, 3.0), 1.0, Vec3(6, 2, -1)), image, options);
    EXPECT_TRUE(flow.hasConverged());
    const Distances d = distancesOf(flow.mesh(), fromEllipsoid);
    EXPECT_LT(std::abs(d.mean), 0.1);
    EXPECT_LT(d.rms, 0.15);
    EXPECT_LT(d.largest, 0.5);
    EXPECT_NEAR(flow.record().volume / (4.0 / 3.0 * 3.14159265 * 22.0 * 14.0 * 10.0), 1.0, 0.04);
  }
}

TEST(Segmentation, ASeedInOneEndGrowsThroughTheNeckOfADumbbell)
{
  for (const double noise : { 0.0, 0.2 })
  {
    const auto image =
      shapes::noisyImage(shapes::voxels(65), fromDumbbell, noise, { 60.0, -100.0 });
    FlowOptions options = imageOptions();
    options.normalSpeed = 1.0;
    const SurfaceFlow flow =
      segmented(shapes::transformed(icosphere(3, 4.0), 1.0, Vec3(18, 0, 0)), image, options);
    EXPECT_TRUE(flow.hasConverged());
    EXPECT_LT(boundingBox(flow.mesh()).min().x(), -28.5);
    const Distances d = distancesOf(flow.mesh(), fromDumbbell);
    EXPECT_LT(std::abs(d.mean), 0.1);
    EXPECT_LT(d.rms, 0.15);
    EXPECT_LT(d.largest, 0.75); // in the crease where balls and neck meet
  }
}

TEST(Segmentation, ABalloonEndsWhereTheImageDoes)
{
  // Half of a ball, cut by the image's side.
  DistanceGrid grid = shapes::voxels(41);
  grid.extent[0] = 20;
  const auto image = shapes::noisyImage(grid, shapes::ballOf(12.0), 0.1);
  FlowOptions options = imageOptions();
  options.normalSpeed = 1.0;
  const SurfaceFlow flow =
    segmented(shapes::transformed(icosphere(3, 3.0), 1.0, Vec3(5, 0, 0)), image, options);
  const Box box = boundingBox(flow.mesh());
  EXPECT_NEAR(box.max().x(), 12.0, 0.5);
  EXPECT_NEAR(box.min().x(), image->box().min().x(), 1.0);
}

TEST(Segmentation, EndsAtOnePlaceWhateverTheTimeStep)
{
  const auto ball = shapes::ballOf(8.0);
  const auto image = shapes::noisyImage(shapes::voxels(31), ball, 0.1);
  const auto meanAtTheEnd = [&](int steps, double speed)
  {
    FlowOptions options = imageOptions();
    options.numberOfSteps = steps;
    options.timeStep = 6.0 / steps;
    options.normalSpeed = speed;
    options.convergenceTolerance = 0.0;
    return distancesOf(
      segmented(icosphere(3, speed > 0.0 ? 3.0 : 11.0), image, options).mesh(), ball)
      .mean;
  };
  EXPECT_NEAR(meanAtTheEnd(60, 0.0), meanAtTheEnd(240, 0.0), 0.01);
  EXPECT_NEAR(meanAtTheEnd(30, 1.0), meanAtTheEnd(240, 1.0), 0.01);
}

TEST(Segmentation, TheSharpnessUsedCanBeSetAgain)
{
  const auto image = shapes::noisyImage(shapes::voxels(31), shapes::ballOf(8.0), 0.0);
  const SurfaceMesh start = icosphere(2, 11.0);
  FlowOptions options = imageOptions();
  const double sharpness = SurfaceFlow(start, image, options).edgeSharpness();
  options.relativeUnits = false;
  const double absolute = SurfaceFlow(start, image, options).edgeSharpness();
  EXPECT_GT(absolute, 0.0);
  EXPECT_NEAR(absolute / sharpness, 0.25 * boundingBox(start).diagonal().squaredNorm(),
    1e-6 * absolute / sharpness);
  options.edgeSharpness = absolute;
  EXPECT_EQ(SurfaceFlow(start, image, options).edgeSharpness(), absolute);
  options.fieldMode = FieldMode::EdgeImage;
  EXPECT_EQ(SurfaceFlow(start, image, options).edgeSharpness(), 0.0);
}
