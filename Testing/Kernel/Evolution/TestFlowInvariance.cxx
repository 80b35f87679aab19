// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// A flow does not depend on where the model is, how large it is and how it is turned. The runs
// compared differ by rounding: by 2e-13 a thousand lengths from the origin, by 8e-15 nearer.

#include "Evolution/SurfaceFlow.h"

#include "Evolution/EvolutionFields.h"
#include "Evolution/FlowRuns.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/SampledOnGrid.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

using namespace evolving;

namespace
{

constexpr double Tolerance = 1e-11; // of the size, which is 1

using Map = std::function<Vec3(const Vec3&)>;
using Field = std::shared_ptr<const ScalarImage>;

/// The options with all kinds of redistribution.
FlowOptions redistributing(FlowOptions options)
{
  options.redistribution.volume = 1.0;
  options.redistribution.angle = 1.0;
  options.redistribution.length = 1.0;
  options.redistribution.curvatureControl = CurvatureControl::TwoThirds;
  return options;
}

SurfaceMesh mapped(SurfaceMesh mesh, const Map& map)
{
  for (Vec3& point : mesh.points)
  {
    point = map(point);
  }
  return mesh;
}

/**
 * Runs the flow of a mesh in a field and that of the mapped mesh in the mapped field.
 * @return the largest distance of a point of the second from the mapped point of the first, over
 * the scale
 */
double difference(const SurfaceMesh& start, const Field& field, const Map& map,
  const Field& mappedField, double scale, const FlowOptions& options)
{
  SurfaceFlow first(start, field, options);
  SurfaceFlow second(mapped(start, map), mappedField, options);
  flows::run(first);
  flows::run(second);
  EXPECT_EQ(first.stopReason() + second.stopReason(), "");
  EXPECT_GT((first.mesh().points[0] - start.points[0]).norm(), 0.05); // something happened
  double largest = 0.0;
  for (std::size_t i = 0; i < start.points.size(); ++i)
  {
    const Vec3 expected = map(first.mesh().points[i]);
    largest = std::max(largest, (second.mesh().points[i] - expected).norm() / scale);
  }
  return largest;
}

/// The distance from an off-centre sphere, in steps that floats hold three times as well.
double roundedDistance(const Vec3& p)
{
  return std::round(4096.0 * ((p - Vec3(0.05, 0.02, -0.03)).norm() - 0.5)) / 4096.0;
}

Field exampleField()
{
  return shapes::image(shapes::cubicGrid(33, 1.6), roundedDistance);
}

/// The same samples at scale * p + offset, scale times as far from the target.
Field moved(const Field& field, double scale, const Vec3& offset)
{
  DistanceGrid grid = field->grid();
  grid.origin = scale * grid.origin + offset;
  grid.spacing *= scale;
  std::vector<float> values = field->values();
  for (float& value : values)
  {
    value = static_cast<float>(scale * value);
  }
  return std::make_shared<const ScalarImage>(grid, values);
}

double differenceInField(double scale, const Vec3& offset)
{
  const Field field = exampleField();
  return difference(
    shapes::bumpySphere(2), field, [&](const Vec3& p) -> Vec3 { return scale * p + offset; },
    moved(field, scale, offset), scale, redistributing(flows::towardsSphere(20)));
}

std::vector<SurfaceMesh> closedAndOpen()
{
  return { shapes::bumpySphere(2), shapes::shakenInside(shapes::halfSphere(6), 0.03, 7) };
}

} // namespace

TEST(FlowInvariance, TranslationsInAField)
{
  EXPECT_LT(differenceInField(1.0, Vec3(10.0, -5.0, 2.5)), Tolerance);
  EXPECT_LT(differenceInField(1.0, Vec3(1000.0, -500.0, 250.0)), Tolerance);
}

TEST(FlowInvariance, ScaleInAField)
{
  EXPECT_LT(differenceInField(3.0, Vec3::Zero()), Tolerance);
  EXPECT_LT(differenceInField(std::pow(2.0, 20), Vec3::Zero()), Tolerance);
  EXPECT_LT(differenceInField(std::pow(2.0, -20), Vec3::Zero()), Tolerance);
}

TEST(FlowInvariance, TurningTheAxesOfAField)
{
  const Map turn = [](const Vec3& p) { return Vec3(p.y(), p.z(), p.x()); };
  const Map back = [](const Vec3& p) { return Vec3(p.z(), p.x(), p.y()); };
  const Field turned = shapes::image(
    shapes::cubicGrid(33, 1.6), [&](const Vec3& p) { return roundedDistance(back(p)); });
  EXPECT_LT(difference(shapes::bumpySphere(2), exampleField(), turn, turned, 1.0,
              redistributing(flows::towardsSphere(20))),
    Tolerance);
}

TEST(FlowInvariance, TranslationsAndScaleOfMeanCurvatureFlow)
{
  FlowOptions options = redistributing(flows::meanCurvatureFlow(0.002, 20));
  options.relativeUnits = true; // in units of the surface's size
  for (const SurfaceMesh& mesh : closedAndOpen())
  {
    for (const double scale : { 1e-4, 0.7, 3e5 })
    {
      const Map map = [&](const Vec3& p) -> Vec3 { return scale * (p + Vec3(7.0, 3.0, -11.0)); };
      EXPECT_LT(difference(mesh, nullptr, map, nullptr, scale, options), Tolerance)
        << mesh.vertexCount() << " vertices, scale " << scale;
    }
  }
}

TEST(FlowInvariance, RotationsOfMeanCurvatureFlow)
{
  // In absolute units: the size of a surface is that of its box, which rotations change.
  const Eigen::Matrix3d rotation = shapes::someRotation();
  const Map map = [&](const Vec3& p) -> Vec3 { return rotation * p; };
  for (const SurfaceMesh& mesh : closedAndOpen())
  {
    EXPECT_LT(difference(mesh, nullptr, map, nullptr, 1.0,
                redistributing(flows::meanCurvatureFlow(0.005, 20))),
      Tolerance)
      << mesh.vertexCount() << " vertices";
  }
}
