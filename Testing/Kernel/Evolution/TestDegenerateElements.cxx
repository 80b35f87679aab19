// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/DegenerateElements.h"

#include "Mesh/MeshQuality.h"
#include "Mesh/PolygonTriangulation.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace evolving;

TEST(DegenerateElements, AreThoseWithASmallAngle)
{
  SurfaceMesh sphere = icosphere(3);
  EXPECT_FALSE(hasDegenerateElements(sphere, BoundaryMode::Fixed, 1.0));
  EXPECT_FALSE(hasDegenerateElements(cubeSphere(8), BoundaryMode::Fixed, 1.0));
  const Index a = sphere.faceVertex(5, 0);
  const Index b = sphere.faceVertex(5, 1);
  sphere.points[at(a)] += 0.9 * (sphere.points[at(b)] - sphere.points[at(a)]);
  EXPECT_TRUE(hasDegenerateElements(sphere, BoundaryMode::Fixed, 1.0));
}

TEST(DegenerateElements, AtABoundaryCountOnlyWhereItIsFree)
{
  SurfaceMesh triangle;
  triangle.addPoint(Vec3(0, 0, 0));
  triangle.addPoint(Vec3(1, 0, 0));
  triangle.addPoint(Vec3(0.5, 0.05, 0));
  triangle.addFace({ 0, 1, 2 });
  EXPECT_FALSE(hasDegenerateElements(triangle, BoundaryMode::Fixed, 1.0));
  EXPECT_TRUE(hasDegenerateElements(triangle, BoundaryMode::Free, 1.0));
}

TEST(DegenerateElements, GetTimeWhereSharpEdgesAreToBeRounded)
{
  // A point in the middle of a side goes to one beside it, four fifths of the way.
  std::vector<Index> oldFace;
  SurfaceMesh box = triangulate(subdividedBox(6), oldFace);
  const double edge = 1.0 / 6.0;
  const auto middle = std::find_if(box.points.begin(), box.points.end(),
    [](const Vec3& p) { return (p - Vec3(0.0, 0.0, 0.5)).norm() < 1e-9; });
  ASSERT_NE(middle, box.points.end());
  middle->x() = 0.8 * edge;
  EXPECT_LT(smallestAngle(box), 15.0);
  EXPECT_FALSE(hasDegenerateElements(box, BoundaryMode::Fixed, edge));
  EXPECT_TRUE(hasDegenerateElements(box, BoundaryMode::Fixed, 0.1 * edge));
  middle->x() = 0.99 * edge;
  EXPECT_TRUE(hasDegenerateElements(box, BoundaryMode::Fixed, edge));
}

TEST(DegenerateElements, AreReplacedByAsManyAsBefore)
{
  EXPECT_EQ(wantedVertices(icosphere(5)), 10242.0);
  EXPECT_EQ(wantedVertices(icosphere(1)), 2562.0); // a coarse start gets enough to look smooth
}

TEST(DegenerateElements, ACoarseStartHasLessThanAQuarterOfTheVertices)
{
  const SurfaceMesh sphere = icosphere(3); // 642 vertices
  EXPECT_FALSE(isCoarse(sphere, wantedVertices(sphere)));
  EXPECT_FALSE(isCoarse(sphere, 4.0 * 642.0));
  EXPECT_TRUE(isCoarse(sphere, 4.0 * 642.0 + 1.0));
  EXPECT_TRUE(isCoarse(subdividedBox(1), wantedVertices(subdividedBox(1))));
}
