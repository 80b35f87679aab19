// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// However an evolution ends, it ends well: finite, no face turned over, one sentence if it stopped.

#include "Evolution/EvolutionFields.h"
#include "Evolution/FlowCourse.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/SampledOnGrid.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <algorithm>
#include <cmath>

using namespace evolving;

namespace
{

/// An icosphere drawn out along z and thin at the middle.
SurfaceMesh dumbbell(int level, double neck)
{
  SurfaceMesh mesh = icosphere(level);
  for (Vec3& p : mesh.points)
  {
    const double width = neck + (1.0 - neck) * std::pow(std::min(1.0, 1.5 * std::abs(p.z())), 2);
    p = p.cwiseProduct(Vec3(width, width, 2.0));
  }
  return mesh;
}

/// Steps of `factor` mean co-volumes.
FlowOptions curvatureFlow(const SurfaceMesh& start, double factor, int steps, double rate = 0.0)
{
  FlowOptions options;
  options.relativeUnits = false;
  options.timeStep = factor * surfaceArea(start) / start.vertexCount();
  options.numberOfSteps = steps;
  options.redistribution.volume = rate;
  options.redistribution.angle = 0.1 * rate;
  return options;
}

} // namespace

TEST(FlowEnds, ANeckPinchesOffWithoutTurningFacesOver)
{
  for (const double factor : { 1.0, 10.0 })
  {
    for (const double rate : { 0.0, 10.0 })
    {
      SCOPED_TRACE(std::to_string(factor) + " co-volumes, rate " + std::to_string(rate));
      const SurfaceMesh start = dumbbell(3, 0.25);
      // The neck is thinnest at about 6 mean co-volumes, and the lobes have then lost a third.
      const Course course =
        follow(start, nullptr, curvatureFlow(start, factor, int(9 / factor) + 2, rate));
      EXPECT_EQ(course.turnedFaces, 0);
      EXPECT_EQ(course.stopReason, "");
    }
  }
}

TEST(FlowEnds, AComponentThatVanishesLeavesTheOthersAlone)
{
  const SurfaceMesh large = shapes::bumpySphere(2);
  for (const double radius : { 0.3, 0.1, 1e-3 })
  {
    for (const int level : { 1, 3 }) // a tenth and four fifths of all faces
    {
      SCOPED_TRACE(std::to_string(radius) + " level " + std::to_string(level));
      const SurfaceMesh small = shapes::transformed(icosphere(level), radius, Vec3(3, 0, 0));
      FlowOptions options;
      options.relativeUnits = false;
      options.timeStep = 5e-4;
      options.numberOfSteps = 100; // the small ones are gone after 45 steps at the latest
      options.redistribution.volume = 1.0;
      const Course alone = follow(large, nullptr, options);
      const Course both = follow(shapes::merged(large, small), nullptr, options);
      EXPECT_EQ(both.stopReason, "");
      EXPECT_EQ(both.record.iteration, 100);
      EXPECT_NEAR(both.record.area, alone.record.area, 1e-6 * alone.record.area);
      for (std::size_t i = 0; i < large.points.size(); ++i)
      {
        EXPECT_LT((both.points[i] - alone.points[i]).norm(), 1e-6);
      }
      for (std::size_t i = large.points.size(); i < both.points.size(); ++i)
      {
        EXPECT_LT((both.points[i] - Vec3(3, 0, 0)).norm(), 1e-3 * radius);
      }
    }
  }
}

TEST(FlowEnds, ARunEndsWhenAllComponentsHaveVanished)
{
  const SurfaceMesh start =
    shapes::merged(icosphere(2), shapes::transformed(icosphere(1), 0.5, Vec3(3, 0, 0)));
  FlowOptions options = curvatureFlow(start, 1.0, 1000);
  options.timeStep = 0.01;
  const Course course = follow(start, nullptr, options);
  EXPECT_EQ(course.stopReason, "");
  ASSERT_TRUE(course.extinctionTime);
  EXPECT_NEAR(*course.extinctionTime, 0.25, 0.03); // the larger one's
  EXPECT_LT(course.record.iteration, 30);
}

TEST(FlowEnds, NoPointLeavesTheBoxOfStartAndField)
{
  // Values that are no distances, which is not seen near the target, throw the surface as far as
  // they say.
  const auto field = shapes::image(shapes::cubicGrid(11, 1.6),
    [](const Vec3& p) { return (p.norm() < 1.4 ? 1.0 : 1e30) * (p.norm() - 0.5); });
  const SurfaceMesh start = shapes::transformed(icosphere(2), 1.0, Vec3(1.0, 0.0, 0.0));
  const Course course = follow(start, field, attraction(0.1, 5));
  expectSentence(course.stopReason);
  EXPECT_EQ(course.record.iteration, 0);
  EXPECT_TRUE(course.points == start.points);
}

TEST(FlowEnds, AnEdgeDetectorMovesByAtMostACellAStep)
{
  const auto ball = shapes::image(shapes::cubicGrid(33, 1.6),
    [](const Vec3& p) { return 1.0 / (1.0 + std::exp((p.norm() - 0.6) / 0.1)); });
  FlowOptions options;
  options.fieldMode = FieldMode::Image;
  options.edgeSharpness = 1.0;
  options.curvatureSpeed = 0.0;
  options.advectionSpeed = 1e9;
  options.numberOfSteps = 20;
  const Course course = follow(icosphere(2, 0.9), ball, options);
  EXPECT_EQ(course.stopReason, "");
  for (const Vec3& p : course.points)
  {
    EXPECT_NEAR(p.norm(), 0.6, 0.11); // about the edge, to a cell of 0.1
  }
}
