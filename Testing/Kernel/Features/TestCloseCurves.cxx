// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/CloseCurves.h"

#include "Features/FoldedStrips.h"
#include "Mesh/Angles.h"
#include "Shapes/CreasedShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

constexpr double Length = 4.0;
using Lines = std::vector<int>;

struct Outcome
{
  Lines lines;
  bool hasDropped = false;
};

/// Two creases along y at a distance, beside each other between wide strips.
SurfaceMesh twoCreases(double apart, double left, double right)
{
  return foldedStrips({ 1.0, apart, 1.0 }, { left, right }, Length, 16);
}

Outcome dropped(const SurfaceMesh& mesh, double distance)
{
  const TargetTriangles target(mesh);
  SharpEdges sharp(target, 30.0, false);
  Outcome outcome;
  outcome.hasDropped = dropCloseCurves(target, sharp, distance);
  outcome.lines = sharpLines(target, sharp, 3);
  return outcome;
}

std::size_t sharpAfter(const SurfaceMesh& mesh, double distance)
{
  const TargetTriangles target(mesh);
  SharpEdges sharp(target, 30.0, false);
  dropCloseCurves(target, sharp, distance);
  return sharp.list().size();
}

/// Rings of these radii and heights, one after the other.
SurfaceMesh revolved(const std::vector<std::pair<double, double>>& profile, Index columns)
{
  SurfaceMesh mesh;
  for (const auto& [radius, z] : profile)
  {
    for (Index i = 0; i < columns; ++i)
    {
      const double angle = 2.0 * Pi * i / columns;
      mesh.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  }
  for (Index ring = 0; ring + 1 < static_cast<Index>(profile.size()); ++ring)
  {
    for (Index i = 0; i < columns; ++i)
    {
      const Index a = ring * columns + i;
      const Index b = ring * columns + (i + 1) % columns;
      mesh.addFace({ a, b, b + columns });
      mesh.addFace({ a, b + columns, a + columns });
    }
  }
  return mesh;
}

/// Of each ring: has it sharp edges?
Lines sharpRings(const SurfaceMesh& mesh, Index columns, double distance)
{
  const TargetTriangles target(mesh);
  SharpEdges sharp(target, 30.0, false);
  dropCloseCurves(target, sharp, distance);
  Lines rings(at(mesh.vertexCount() / columns), 0);
  for (const Index edge : sharp.list())
  {
    rings[at(target.edgeVertices(edge)[0] / columns)] = 1;
  }
  return rings;
}

} // namespace

TEST(CloseCurves, OfTwoThatFoldAlikeTheShorterGoes)
{
  // A chamfer around a shaft's end, and one around a hole: 45 degrees on both sides.
  constexpr Index Columns = 48;
  const SurfaceMesh shaft =
    revolved({ { 0.5, 0.0 }, { 1.0, 0.0 }, { 1.05, -0.05 }, { 1.05, -1.0 } }, Columns);
  EXPECT_EQ(sharpRings(shaft, Columns, 0.05), (Lines{ 0, 1, 1, 0 }));
  EXPECT_EQ(sharpRings(shaft, Columns, 0.1), (Lines{ 0, 0, 1, 0 }));
  const SurfaceMesh hole =
    revolved({ { 1.5, 0.0 }, { 1.05, 0.0 }, { 1.0, -0.05 }, { 1.0, -1.0 } }, Columns);
  EXPECT_EQ(sharpRings(hole, Columns, 0.1), (Lines{ 0, 1, 0, 0 }));
}

TEST(CloseCurves, TheWeakerOfTwoGoes)
{
  const Outcome left = dropped(twoCreases(0.1, 40.0, 60.0), 0.11);
  EXPECT_TRUE(left.hasDropped);
  EXPECT_EQ(left.lines, (Lines{ 0, 1 }));
  EXPECT_EQ(dropped(twoCreases(0.1, 60.0, 40.0), 0.11).lines, (Lines{ 1, 0 }));
}

TEST(CloseCurves, AreThoseWithinTheDistance)
{
  const Outcome kept = dropped(twoCreases(0.1, 40.0, 60.0), 0.09);
  EXPECT_FALSE(kept.hasDropped);
  EXPECT_EQ(kept.lines, (Lines{ 1, 1 }));
}

TEST(CloseCurves, MayBeCloseForLessThanHalfTheirWay)
{
  // Along `part` of their way the lines are less than 0.15 apart; then they part slowly, so that
  // the bend is no crease itself, to 0.4.
  const auto bent = [](double part)
  {
    SurfaceMesh mesh = twoCreases(0.4, 40.0, 60.0);
    const Vec3 across(std::cos(40.0 * Pi / 180.0), 0.0, std::sin(40.0 * Pi / 180.0));
    for (Index i = 0; i < mesh.vertexCount(); ++i)
    {
      Vec3& p = mesh.points[static_cast<std::size_t>(i)];
      const double shift = 0.3 * std::clamp((part * Length + 1.0 - p.y()) / 1.2, 0.0, 1.0);
      p -= i % 4 >= 2 ? Vec3(shift * across) : Vec3(Vec3::Zero());
    }
    return mesh;
  };
  EXPECT_FALSE(dropped(bent(0.4), 0.15).hasDropped);
  EXPECT_EQ(dropped(bent(0.8), 0.15).lines, (Lines{ 0, 1 }));
}

TEST(CloseCurves, OfDifferentSurfacesMayBeClose)
{
  // The same creases twice, one above the other: no patch has curves of both.
  const SurfaceMesh one = twoCreases(1.0, 40.0, 60.0);
  const SurfaceMesh both = merged(one, transformed(one, 1.0, Vec3(0.0, 0.0, 0.05)));
  EXPECT_EQ(sharpAfter(both, 0.2), 4u * 16u);
}

TEST(CloseCurves, MayMeetInACorner)
{
  // Near their corners the edges of a box are close to each other.
  const SurfaceMesh cube = box(Vec3(0, 0, 0), Vec3(1, 1, 1));
  EXPECT_EQ(sharpAfter(cube, 0.15), 12u);
  // And where that is for more than half their way.
  EXPECT_EQ(sharpAfter(cube, 0.3), 12u);
  // Of a plate thinner than the distance, one rim of two remains, and no edge across.
  const std::size_t plate = sharpAfter(box(Vec3(0, 0, 0), Vec3(1, 1, 0.05)), 0.15);
  EXPECT_LT(plate, 12u);
  EXPECT_GE(plate, 4u);
}

TEST(CloseCurves, DoNotDependOnUnitsOrSides)
{
  const SurfaceMesh mesh = twoCreases(0.1, 40.0, 60.0);
  for (const double scale : { 0x1p-30, 1e-3, 1e6 })
  {
    const SurfaceMesh scaled = transformed(mesh, scale, Vec3::Zero());
    EXPECT_EQ(dropped(scaled, 0.11 * scale).lines, (Lines{ 0, 1 })) << scale;
    EXPECT_EQ(dropped(reversed(scaled), 0.11 * scale).lines, (Lines{ 0, 1 })) << scale;
    EXPECT_EQ(dropped(scaled, 0.09 * scale).lines, (Lines{ 1, 1 })) << scale;
  }
}
