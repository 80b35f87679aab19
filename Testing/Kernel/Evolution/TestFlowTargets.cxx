// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Targets that are no ordinary ones: the start itself, a point, far away.

#include "Evolution/EvolutionFields.h"
#include "Evolution/FlowCourse.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/SampledOnGrid.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <algorithm>
#include <functional>
#include <memory>

using namespace evolving;

struct Target
{
  const char* name;
  std::function<double(const Vec3&)> value;
  int samples;     ///< per axis
  double halfSize; ///< of the grid
  double smallest; ///< distance of the result from the origin
  double largest;
};

class FlowOntoTarget : public ::testing::TestWithParam<Target>
{
};

TEST_P(FlowOntoTarget, EndsWithAFiniteSurface)
{
  const Target& target = GetParam();
  const auto field =
    shapes::image(shapes::cubicGrid(target.samples, target.halfSize), target.value);
  const Course course = follow(icosphere(2), field, attraction(0.1, 60));
  EXPECT_EQ(course.turnedFaces, 0);
  EXPECT_EQ(course.stopReason, "");
  EXPECT_FALSE(course.extinctionTime.has_value());
  double smallest = 1e300;
  double largest = 0.0;
  for (const Vec3& p : course.points)
  {
    smallest = std::min(smallest, p.norm());
    largest = std::max(largest, p.norm());
  }
  EXPECT_GE(smallest, target.smallest);
  EXPECT_LE(largest, target.largest);
}

INSTANTIATE_TEST_SUITE_P(Targets, FlowOntoTarget,
  ::testing::Values(
    Target{ "Itself", [](const Vec3& p) { return p.norm() - 1.0; }, 33, 1.6, 0.98, 1.005 },
    Target{ "SmallerThanACell", [](const Vec3& p) { return p.norm() - 0.05; }, 17, 1.6, 0.0, 0.12 },
    Target{ "APoint", [](const Vec3& p) { return p.norm(); }, 17, 1.6, 0.0, 0.1 },
    Target{
      "GridInsideTheStart", [](const Vec3& p) { return p.norm() - 0.3; }, 17, 0.5, 0.27, 0.33 }),
  [](const auto& target) { return std::string(target.param.name); });

TEST(FlowTargets, SizeAndPlaceDoNotMatter)
{
  const DistanceGrid unit = shapes::cubicGrid(17, 1.6);
  const std::vector<float> values =
    shapes::sampled(unit, [](const Vec3& p) { return p.norm() - 0.5; });
  for (const double scale : { 1e-20, 1e-6, 1.0, 1e6, 1e20 })
  {
    for (const double offset : { 0.0, 1e6 }) // in units of the start's radius
    {
      SCOPED_TRACE(std::to_string(std::log10(scale)) + " " + std::to_string(offset));
      const Vec3 centre = Vec3::Constant(offset * scale);
      DistanceGrid grid = unit;
      grid.origin = scale * unit.origin + centre;
      grid.spacing *= scale;
      std::vector<float> scaled = values;
      for (float& value : scaled)
      {
        value *= static_cast<float>(scale);
      }
      const auto field = std::make_shared<const ScalarImage>(grid, scaled);
      const Course course = follow(
        shapes::transformed(shapes::bumpySphere(2), scale, centre), field, attraction(0.05, 100));
      EXPECT_EQ(course.stopReason, "");
      EXPECT_EQ(course.turnedFaces, 0);
      for (const Vec3& p : course.points)
      {
        EXPECT_NEAR((p - centre).norm() / scale, 0.5, 0.02);
      }
    }
  }
}
