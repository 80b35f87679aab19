// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/CarriableFeatures.h"
#include "Features/TargetFeatures.h"
#include "Mesh/Angles.h"
#include "Shapes/CreasedShapes.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

TargetFeatures carried(const SurfaceMesh& mesh, double edgeLength, double angle = 30.0)
{
  FeatureOptions options;
  options.angle = angle;
  options.edgeLength = edgeLength;
  return findFeatures(mesh, options);
}

/// A square prism of side 1 with one edge along z cut off, so far that the new face is this wide.
SurfaceMesh chamferedBox(double width)
{
  const double cut = width / std::sqrt(2.0);
  return extruded(
    { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1 - cut, 0), Vec3(1 - cut, 1, 0), Vec3(0, 1, 0) }, 1.0);
}

/// The same with an edge rounded by a number of strips.
SurfaceMesh filletedBox(double radius, int strips)
{
  std::vector<Vec3> polygon{ Vec3(0, 0, 0), Vec3(1, 0, 0) };
  for (int k = 0; k <= strips; ++k)
  {
    const double angle = 0.5 * Pi * k / strips;
    polygon.push_back(
      Vec3(1 - radius, 1 - radius, 0) + radius * Vec3(std::cos(angle), std::sin(angle), 0));
  }
  polygon.emplace_back(0, 1, 0);
  return extruded(polygon, 1.0);
}

/// Kept curves along z that begin near the box's edge at (1, 1).
int creasesAtTheCutEdge(const TargetFeatures& features)
{
  int count = 0;
  for (const FeatureCurve& curve : features.curves().curves())
  {
    const Vec3& from = features.target().point(curve.vertices.front());
    const Vec3& to = features.target().point(curve.vertices.back());
    count += std::abs(to.z() - from.z()) == 1.0 && from.x() + from.y() > 1.5 ? 1 : 0;
  }
  return count;
}

} // namespace

TEST(CarriableFeatures, AreAllWithoutAnEdgeLength)
{
  const TargetFeatures box = carried(chamferedBox(0.01), 0.0);
  EXPECT_EQ(box.labelCount(), 7);
  EXPECT_EQ(creasesAtTheCutEdge(box), 2);
  EXPECT_EQ(box.leftOut().length, 0.0);
}

TEST(CarriableFeatures, HaveOneCreaseForANarrowChamfer)
{
  const double edgeLength = 0.1;
  const TargetFeatures narrow = carried(chamferedBox(0.3 * edgeLength), edgeLength);
  EXPECT_EQ(creasesAtTheCutEdge(narrow), 1);
  EXPECT_EQ(narrow.labelCount(), 6);
  EXPECT_EQ(narrow.curves().curves().size(), 12u);
  EXPECT_EQ(narrow.curves().corners().size(), 8u);
  EXPECT_NEAR(narrow.leftOut().length, 1.0, 1e-12);
  const TargetFeatures wide = carried(chamferedBox(1.5 * edgeLength), edgeLength);
  EXPECT_EQ(creasesAtTheCutEdge(wide), 2);
  EXPECT_EQ(wide.labelCount(), 7);
}

TEST(CarriableFeatures, HaveOneCreaseForAFilletOfNarrowStrips)
{
  // Three folds of 22.5 degrees between strips and two of 11.25 to the sides.
  const TargetFeatures all = carried(filletedBox(0.02, 4), 0.0, 20.0);
  EXPECT_EQ(creasesAtTheCutEdge(all), 3);
  const TargetFeatures fillet = carried(filletedBox(0.02, 4), 0.1, 20.0);
  EXPECT_EQ(creasesAtTheCutEdge(fillet), 1);
  EXPECT_EQ(fillet.labelCount(), 6);
}

TEST(CarriableFeatures, HaveOneCreaseRoundAThinPlate)
{
  const TargetFeatures plate = carried(box(Vec3(0, 0, 0), Vec3(1, 1, 0.04)), 0.1);
  EXPECT_EQ(plate.labelCount(), 2);
  EXPECT_EQ(plate.curves().curves().size(), 4u);
  EXPECT_EQ(plate.curves().corners().size(), 4u);
  EXPECT_NEAR(plate.borders().length(EdgeKind::Sharp), 4.0, 1e-12);
}

TEST(CarriableFeatures, DoNotIncludeRoughPlaces)
{
  SurfaceMesh rough = sphere(4);
  rough.points[100] *= 1.2;
  EXPECT_GT(carried(rough, 0.0).curves().curves().size(), 0u);
  EXPECT_EQ(carried(rough, 0.5).curves().curves().size(), 0u);
}

TEST(CarriableFeatures, OfAShapeSmallerThanElementsAreNone)
{
  const TargetFeatures box = carried(shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), 2.0);
  EXPECT_EQ(box.labelCount(), 1);
  EXPECT_TRUE(box.sharpEdges().list().empty());
  EXPECT_NEAR(box.leftOut().length, 12.0, 1e-12);
}

TEST(CarriableFeatures, KeepOneOfTwoCloseCreasesOfAWidePatch)
{
  // A dumbbell: two squares of side 1, a neck of length 1 and width 0.05 between them.
  const double w = 0.025;
  const SurfaceMesh dumbbell =
    extruded({ Vec3(-1.5, -0.5, 0), Vec3(-0.5, -0.5, 0), Vec3(-0.5, -w, 0), Vec3(0.5, -w, 0),
               Vec3(0.5, -0.5, 0), Vec3(1.5, -0.5, 0), Vec3(1.5, 0.5, 0), Vec3(0.5, 0.5, 0),
               Vec3(0.5, w, 0), Vec3(-0.5, w, 0), Vec3(-0.5, 0.5, 0), Vec3(-1.5, 0.5, 0) },
      1.0);
  const auto neckCreases = [&dumbbell](double edgeLength)
  {
    const TargetFeatures features = carried(dumbbell, edgeLength);
    int count = 0;
    for (const FeatureCurve& curve : features.curves().curves())
    {
      const Vec3 middle = 0.5 *
        (features.target().point(curve.vertices.front()) +
          features.target().point(curve.vertices.back()));
      count += curve.length == 1.0 && std::abs(middle.x()) < 0.1 ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(neckCreases(0.0), 4);
  EXPECT_EQ(neckCreases(0.1), 2);
}

TEST(CarriableFeatures, KeepDartsLongerThanElements)
{
  const TargetFeatures ridge = carried(fadingRidge(20), 0.1, 60.0);
  ASSERT_EQ(ridge.curves().curves().size(), 1u);
  EXPECT_NEAR(ridge.curves().curves().front().length, 0.8, 1e-12);
  EXPECT_TRUE(carried(fadingRidge(20), 0.5, 60.0).curves().curves().empty());
}
