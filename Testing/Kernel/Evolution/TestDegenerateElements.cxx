// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/DegenerateElements.h"

#include "Mesh/MeshQuality.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;

TEST(DegenerateElements, AreThoseWithASmallAngle)
{
  SurfaceMesh sphere = icosphere(3);
  EXPECT_FALSE(hasDegenerateElements(sphere, BoundaryMode::Fixed));
  EXPECT_FALSE(hasDegenerateElements(cubeSphere(8), BoundaryMode::Fixed));
  const Index a = sphere.faceVertex(5, 0);
  const Index b = sphere.faceVertex(5, 1);
  sphere.points[at(a)] += 0.9 * (sphere.points[at(b)] - sphere.points[at(a)]);
  EXPECT_TRUE(hasDegenerateElements(sphere, BoundaryMode::Fixed));
}

TEST(DegenerateElements, AtABoundaryCountOnlyWhereItIsFree)
{
  SurfaceMesh triangle;
  triangle.addPoint(Vec3(0, 0, 0));
  triangle.addPoint(Vec3(1, 0, 0));
  triangle.addPoint(Vec3(0.5, 0.05, 0));
  triangle.addFace({ 0, 1, 2 });
  EXPECT_FALSE(hasDegenerateElements(triangle, BoundaryMode::Fixed));
  EXPECT_TRUE(hasDegenerateElements(triangle, BoundaryMode::Free));
}

TEST(DegenerateElements, AreReplacedByAsManyAsBefore)
{
  const SurfaceMesh fine = icosphere(5);
  EXPECT_NEAR(coveringEdgeLength(fine), meanEdgeLength(fine), 0.02 * meanEdgeLength(fine));
  // A coarse start gets enough to look smooth.
  EXPECT_NEAR(coveringEdgeLength(icosphere(1)), meanEdgeLength(icosphere(4)), 0.01);
}
