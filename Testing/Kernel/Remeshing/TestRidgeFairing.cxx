// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Roofs whose ridge is a row of saw teeth, or straight.

#include "Remeshing/RidgeFairing.h"

#include "Mesh/MeshQuality.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/RemeshingShapes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace evolving;

constexpr Index Rows = 12;
constexpr Index Columns = 8; ///< on each side of the ridge
constexpr double Step = 0.1;
constexpr double Slope = 0.45; ///< no edge beside the ridge folds by 30 degrees

Index pointOf(Index row, Index column)
{
  return row * (2 * Columns + 1) + column;
}

/// Two planes that meet in x = 0; the ridge's points are off it by a part of a
/// step, to one side and the other.
SurfaceMesh roof(double teeth)
{
  SurfaceMesh mesh;
  for (Index row = 0; row <= Rows; ++row)
  {
    for (Index column = 0; column <= 2 * Columns; ++column)
    {
      const double away = Step * static_cast<double>(column - Columns);
      const bool isInside = row > 0 && row < Rows;
      const double side = isInside && column == Columns ? (row % 2 == 0 ? 1.0 : -1.0) : 0.0;
      mesh.addPoint(
        { away + side * teeth * Step, Step * static_cast<double>(row), -Slope * std::abs(away) });
    }
  }
  for (Index row = 0; row < Rows; ++row)
  {
    for (Index column = 0; column < 2 * Columns; ++column)
    {
      const Index a = pointOf(row, column), b = pointOf(row, column + 1);
      const Index c = pointOf(row + 1, column + 1), d = pointOf(row + 1, column);
      mesh.addFace({ a, b, c });
      mesh.addFace({ a, c, d });
    }
  }
  return mesh;
}

/// The roof without teeth.
class Roof : public ReferenceSurface
{
public:
  Foot onSurface(
    const Vec3& point, const Vec3& /*facing*/, Index /*label*/, Index /*guess*/) const override
  {
    const Vec3 normal = Vec3(point.x() < 0.0 ? -Slope : Slope, 0.0, 1.0).normalized();
    return { point - normal.dot(point) * normal, normal, NoIndex };
  }
};

/// The largest distance of a point of the ridge from where it should be.
double teethOf(const EditableSurface& surface)
{
  double teeth = 0.0;
  for (Index row = 1; row < Rows; ++row)
  {
    teeth = std::max(teeth, std::abs(surface.point(pointOf(row, Columns)).x()));
  }
  return teeth / Step;
}

Index ridgeEdge(const EditableSurface& surface, Index row)
{
  Index found = NoIndex;
  surface.forEachOutgoing(pointOf(row, Columns),
    [&](Index e) { found = surface.to(e) == pointOf(row + 1, Columns) ? e : found; });
  return found;
}

TEST(RidgeFairing, TeethBecomeAStraightRidge)
{
  EditableSurface surface = shapes::sized(roof(0.4), Step);
  EXPECT_NEAR(teethOf(surface), 0.4, 1e-12);
  EXPECT_GE(fairRidges(surface, Roof()), Rows - 1);
  EXPECT_LT(teethOf(surface), 0.2); // turns by less than 40 degrees
}

TEST(RidgeFairing, AStraightRidgeStays)
{
  EditableSurface surface = shapes::sized(roof(0.0), Step);
  const SurfaceMesh before = surface.mesh();
  EXPECT_EQ(fairRidges(surface, Roof()), 0);
  EXPECT_TRUE(surface.mesh() == before);
}

TEST(RidgeFairing, WhatDoesNotFoldStays)
{
  EditableSurface surface = shapes::sized(icosphere(2), 0.3);
  EXPECT_EQ(fairRidges(surface, shapes::ExactSphere()), 0);
}

TEST(RidgeFairing, TeethOfTheTargetItselfStay)
{
  const SurfaceMesh target = roof(0.4);
  EditableSurface surface = shapes::sized(target, Step);
  fairRidges(surface, OffsetReference(target, 0.0)); // others may move within their planes
  EXPECT_EQ(teethOf(surface), teethOf(EditableSurface(target)));
}

TEST(RidgeFairing, NothingGoesFartherThanAllowed)
{
  for (const double farthest : { 0.1, 0.3 })
  {
    EditableSurface surface = shapes::sized(roof(0.4), Step);
    const SurfaceMesh before = surface.mesh();
    RidgeFairingOptions options;
    options.farthest = farthest;
    fairRidges(surface, Roof(), options);
    double moved = 0.0;
    for (Index v = 0; v < surface.vertexSlots(); ++v)
    {
      moved = std::max(moved, (surface.point(v) - before.points[at(v)]).norm());
    }
    EXPECT_LE(moved, farthest * Step * (1.0 + 1e-12));
    EXPECT_GT(moved, 0.9 * farthest * Step);
  }
}

TEST(RidgeFairing, CurvesAndPinnedVerticesStay)
{
  EditableSurface surface = shapes::sized(roof(0.4), Step);
  surface.setCurve(ridgeEdge(surface, 3), 0);
  surface.setCurve(ridgeEdge(surface, 4), 0);
  surface.setPinned(pointOf(8, Columns));
  const SurfaceMesh before = surface.mesh();
  EXPECT_GT(fairRidges(surface, Roof()), 0);
  for (const Index row : { 3, 4, 5, 8 })
  {
    EXPECT_EQ(surface.point(pointOf(row, Columns)), before.points[at(pointOf(row, Columns))])
      << row;
  }
}

TEST(RidgeFairing, AnglesStaySound)
{
  EditableSurface surface = shapes::sized(roof(0.4), Step);
  const double before = summarizeAngles(surface.mesh()).smallest;
  RidgeFairingOptions options;
  options.leastAngle = 25.0;
  fairRidges(surface, Roof(), options);
  EXPECT_GE(summarizeAngles(surface.mesh()).smallest, std::min(before, options.leastAngle) - 1e-9);
}

} // namespace
