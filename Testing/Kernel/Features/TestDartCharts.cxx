// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/TargetFeatures.h"
#include "Mesh/Angles.h"
#include "Shapes/CreasedShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

/// Sharp edges of which two faces have one label.
int unseparatedEdges(const TargetFeatures& features)
{
  int count = 0;
  const TriangleEdges& edges = features.target().edges();
  for (const Index edge : features.sharpEdges().list())
  {
    for (const Index* a = edges.begin(edge); a != edges.end(edge); ++a)
    {
      for (const Index* b = a + 1; b != edges.end(edge); ++b)
      {
        count += features.labelOf(*a / 3) == features.labelOf(*b / 3) ? 1 : 0;
      }
    }
  }
  return count;
}

TargetFeatures featuresOf(const SurfaceMesh& mesh, double angle = 45.0, double edgeLength = 0.0)
{
  FeatureOptions options;
  options.angle = angle;
  options.edgeLength = edgeLength;
  return findFeatures(mesh, options);
}

/// A band with half a turn and a crease of 2 atan(1) along its core, which has one side only.
SurfaceMesh creasedMoebiusBand(Index count)
{
  SurfaceMesh mesh;
  for (Index i = 0; i < count; ++i)
  {
    const double around = 2.0 * Pi * i / count;
    const Vec3 outwards(std::cos(around), std::sin(around), 0.0);
    const Vec3 across = std::cos(0.5 * around) * outwards + std::sin(0.5 * around) * Vec3::UnitZ();
    const Vec3 up = std::cos(0.5 * around) * Vec3::UnitZ() - std::sin(0.5 * around) * outwards;
    // The crease points up at the beginning and down at the end, so it is flat in between.
    const double height = 0.3 * std::cos(0.5 * around);
    for (const double side : { -1.0, 0.0, 1.0 })
    {
      mesh.addPoint(4.0 * outwards + 0.3 * side * across + (side == 0.0 ? height : 0.0) * up);
    }
  }
  const auto number = [count](Index i, Index k) { return i < count ? 3 * i + k : 2 - k; };
  for (Index i = 0; i < count; ++i)
  {
    for (const Index k : { 0, 1 })
    {
      mesh.addFace({ number(i, k), number(i + 1, k), number(i + 1, k + 1) });
      mesh.addFace({ number(i, k), number(i + 1, k + 1), number(i, k + 1) });
    }
  }
  return mesh;
}

} // namespace

TEST(DartCharts, LeavePatchesWithoutDartsAlone)
{
  const TargetFeatures cube = featuresOf(box(Vec3(0, 0, 0), Vec3(1, 1, 1)));
  EXPECT_EQ(cube.labelCount(), 6);
  EXPECT_EQ(cube.borders().length(EdgeKind::Artificial), 0.0);
  const TargetFeatures cylinder = featuresOf(extruded(regularPolygon(32), 1.0));
  EXPECT_EQ(cylinder.labelCount(), 3);
  EXPECT_EQ(featuresOf(sphere(4)).labelCount(), 1);
}

TEST(DartCharts, ContinueAFadingRidge)
{
  const TargetFeatures ridge = featuresOf(fadingRidge(20), 60.0);
  EXPECT_EQ(ridge.patchCount(), 1);
  EXPECT_EQ(ridge.labelCount(), 2);
  EXPECT_EQ(unseparatedEdges(ridge), 0);
  // The border goes on along what is left of the fold, to the boundary.
  EXPECT_NEAR(ridge.borders().length(EdgeKind::Sharp), 0.8, 1e-12);
  EXPECT_NEAR(ridge.borders().length(EdgeKind::Artificial), 1.2, 1e-12);
  for (Index edge = 0; edge < ridge.target().edges().edgeCount(); ++edge)
  {
    if (ridge.borders().kind(edge) != EdgeKind::Inner)
    {
      const auto [a, b] = ridge.target().edgeVertices(edge);
      EXPECT_NEAR(ridge.target().point(a).y(), 0.0, 1e-12);
      EXPECT_NEAR(ridge.target().point(b).y(), 0.0, 1e-12);
    }
  }
}

TEST(DartCharts, GiveAShortCreaseFarFromOthersAStripBesideIt)
{
  // A ridge from the boundary into a plane; its slope falls from 1 to 0 between -0.6 and -0.2.
  const auto slope = [](double x)
  { return std::pow(std::cos(0.5 * Pi * std::clamp((x + 0.6) / 0.4, 0.0, 1.0)), 2); };
  const SurfaceMesh field = heightField(
    40, [&](double x, double y) { return -std::abs(y) * std::exp(-4.0 * y * y) * slope(x); });
  const TargetFeatures ridge = featuresOf(field, 60.0);
  EXPECT_EQ(ridge.curves().curves().size(), 1u);
  EXPECT_EQ(ridge.labelCount(), 2);
  EXPECT_EQ(unseparatedEdges(ridge), 0);
  // The way ahead would be 1.4 long, the ridge is 0.6.
  EXPECT_GT(ridge.borders().length(EdgeKind::Artificial), 0.6);
  EXPECT_LT(ridge.borders().length(EdgeKind::Artificial), 1.2);
  for (Index edge = 0; edge < ridge.target().edges().edgeCount(); ++edge)
  {
    if (ridge.borders().kind(edge) == EdgeKind::Artificial)
    {
      EXPECT_LT(ridge.target().point(ridge.target().edgeVertices(edge)[0]).x(), 0.0);
    }
  }
}

TEST(DartCharts, GiveAValleyInsideASecondLabel)
{
  const TargetFeatures wedge = featuresOf(pressedWedge(40), 45.0);
  ASSERT_EQ(wedge.curves().curves().size(), 1u);
  EXPECT_EQ(wedge.curves().corners().size(), 2u);
  EXPECT_EQ(wedge.patchCount(), 1);
  EXPECT_EQ(wedge.labelCount(), 2);
  EXPECT_EQ(unseparatedEdges(wedge), 0);
  // The straight way through both ends to the boundary is 2 minus the valley long.
  const double valley = wedge.borders().length(EdgeKind::Sharp);
  EXPECT_GT(wedge.borders().length(EdgeKind::Artificial), 0.5 * valley);
  EXPECT_LT(wedge.borders().length(EdgeKind::Artificial), 2.0 * (2.0 - valley));
}

TEST(DartCharts, CutCreasesWithOneSide)
{
  const TargetFeatures band = featuresOf(creasedMoebiusBand(60), 30.0);
  EXPECT_GT(band.sharpEdges().list().size(), 40u);
  EXPECT_EQ(unseparatedEdges(band), 0);
  EXPECT_LE(band.labelCount(), 3);
}

TEST(DartCharts, SeparateEverySideOnRandomPrisms)
{
  std::mt19937 generator(11);
  for (int trial = 0; trial < 50; ++trial)
  {
    const SurfaceMesh prism = extruded(randomPolygon(generator), 0.7);
    for (const double angle : { 20.0, 60.0, 100.0 })
    {
      EXPECT_EQ(unseparatedEdges(featuresOf(prism, angle)), 0) << trial << ' ' << angle;
    }
  }
}

TEST(DartCharts, SeparateEverySideOnRandomBlocks)
{
  std::mt19937 generator(12);
  std::uniform_int_distribution<int> any(0, 2);
  for (int trial = 0; trial < 20; ++trial)
  {
    // Any cells, so edges of four faces, too; with random points, so darts as well.
    std::set<std::array<int, 3>> cells;
    for (int i = 0; i < 40; ++i)
    {
      cells.insert({ any(generator) + any(generator), any(generator), any(generator) });
    }
    SurfaceMesh blocks = triangulated(cellSurface(cells), generator);
    EXPECT_EQ(unseparatedEdges(featuresOf(blocks)), 0) << trial;
    for (Vec3& point : blocks.points)
    {
      point += 0.3 * randomPoint(generator);
    }
    const TargetFeatures rough = featuresOf(blocks, 70.0);
    EXPECT_EQ(unseparatedEdges(rough), 0) << trial;
    // The cells are 1 wide: elements of 0.3 can carry nearly all of their edges, of 1 far from all.
    const TargetFeatures fine = featuresOf(blocks, 70.0, 0.3);
    EXPECT_EQ(unseparatedEdges(fine), 0) << trial;
    const TargetFeatures coarse = featuresOf(blocks, 70.0, 1.0);
    EXPECT_EQ(unseparatedEdges(coarse), 0) << trial;
    EXPECT_GT(coarse.leftOut().length, fine.leftOut().length) << trial;
    EXPECT_LT(coarse.curves().curves().size(), rough.curves().curves().size()) << trial;
  }
}

TEST(DartCharts, MakeConnectedLabelsNumberedBySmallestTriangle)
{
  std::mt19937 generator(13);
  SurfaceMesh rough = sphere(4);
  for (Vec3& point : rough.points)
  {
    point *= 1.0 + 0.05 * randomPoint(generator).x();
  }
  const TargetFeatures features = featuresOf(rough, 45.0);
  EXPECT_EQ(unseparatedEdges(features), 0);
  EXPECT_GT(features.labelCount(), features.patchCount());
  std::vector<Index> names;
  Index next = 0;
  for (Index face = 0; face < features.target().mesh().faceCount(); ++face)
  {
    names.push_back(features.labelOf(face));
    EXPECT_LE(names.back(), next);
    next = std::max(next, names.back() + 1);
  }
  EXPECT_EQ(next, features.labelCount());
  EXPECT_EQ(connectedSets(features.target(), features.sharpEdges(), names).ofTriangle, names);
}
