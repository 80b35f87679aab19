// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/FacetedParts.h"

#include "Shapes/CreasedShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

using namespace evolving;

namespace
{

/// How many edges are sharp, where none was.
std::size_t facetEdges(const SurfaceMesh& surface, double angle, double leastMean)
{
  const TargetTriangles target(surface);
  SharpEdges sharp(target, 180.0, false);
  EXPECT_TRUE(sharp.list().empty());
  takeFacetEdges(target, sharp, { angle, angle, 36.0 }, leastMean);
  return sharp.list().size();
}

/// Its 30 edges are 1.0515 long and fold by 41.8 degrees.
SurfaceMesh icosahedron()
{
  return icosphere(0);
}

} // namespace

TEST(FacetEdges, AreThoseThatFoldByMore)
{
  EXPECT_EQ(facetEdges(icosahedron(), 41.0, 0.1), 30U);
  EXPECT_EQ(facetEdges(icosahedron(), 42.0, 0.1), 0U);
  // The diagonals of its sides are flat.
  EXPECT_EQ(facetEdges(shapes::unitCube(), 30.0, 0.1), 12U);
  EXPECT_EQ(facetEdges(shapes::unitCube(), 90.0, 0.1), 0U);
}

TEST(FacetEdges, AreLongOnAverage)
{
  EXPECT_EQ(facetEdges(icosahedron(), 30.0, 1.051), 30U);
  EXPECT_EQ(facetEdges(icosahedron(), 30.0, 1.052), 0U);
  // Of a box 1 x 2 x 3: each length counts by itself, (1 + 4 + 9) / (1 + 2 + 3).
  const SurfaceMesh box = shapes::box(Vec3(0, 0, 0), Vec3(1, 2, 3));
  EXPECT_EQ(facetEdges(box, 30.0, 2.33), 12U);
  EXPECT_EQ(facetEdges(box, 30.0, 2.34), 0U);
}

TEST(FacetEdges, AreJudgedPartByPart)
{
  const SurfaceMesh both =
    shapes::merged(icosahedron(), shapes::transformed(icosahedron(), 0.1, Vec3(3, 0, 0)));
  EXPECT_EQ(facetEdges(both, 30.0, 0.5), 30U);
  EXPECT_EQ(facetEdges(both, 30.0, 0.1), 60U);
}

TEST(FacetEdges, AreNotAddedToSharpOnes)
{
  // Beside the rims of a prism of 12 sides these fold by 30 degrees.
  const TargetTriangles target(shapes::extruded(shapes::regularPolygon(12), 1.0));
  SharpEdges sharp(target, 45.0, false);
  const std::size_t rims = sharp.list().size();
  EXPECT_EQ(rims, 24U);
  takeFacetEdges(target, sharp, { 20.0, 10.0, 36.0 }, 0.1);
  EXPECT_EQ(sharp.list().size(), rims);
}

namespace
{

/// A pyramid of height 0.3 over a square of side 2: it folds by 163 degrees at the base and by 23.6
/// at its slant edges, which make angles of 46.2 degrees with those of the base.
SurfaceMesh flatPyramid()
{
  SurfaceMesh mesh;
  mesh.addPoint(Vec3(0, 0, 0.3));
  for (const Vec3& corner : { Vec3(1, 1, 0), Vec3(-1, 1, 0), Vec3(-1, -1, 0), Vec3(1, -1, 0) })
  {
    mesh.addPoint(corner);
  }
  for (Index k = 0; k < 4; ++k)
  {
    mesh.addFace({ 0, 1 + k, 1 + (k + 1) % 4 });
  }
  mesh.addFace({ 4, 3, 2 });
  mesh.addFace({ 4, 2, 1 });
  return mesh;
}

std::size_t facetEdges(const SurfaceMesh& surface, const FacetFolds& folds)
{
  const TargetTriangles target(surface);
  SharpEdges sharp(target, 180.0, false);
  takeFacetEdges(target, sharp, folds, 0.1);
  return sharp.list().size();
}

} // namespace

TEST(FacetEdges, MayBeFaint)
{
  EXPECT_EQ(facetEdges(flatPyramid(), { 30.0, 23.0, 36.0 }), 8U);
  EXPECT_EQ(facetEdges(flatPyramid(), { 30.0, 24.0, 36.0 }), 4U);
}

TEST(FacetEdges, MakeNoNarrowWedgesWhereTheyAreFaint)
{
  EXPECT_EQ(facetEdges(flatPyramid(), { 30.0, 5.0, 46.0 }), 8U);
  EXPECT_EQ(facetEdges(flatPyramid(), { 30.0, 5.0, 47.0 }), 4U);
  EXPECT_EQ(facetEdges(flatPyramid(), { 23.0, 5.0, 47.0 }), 8U); // all of them are seen
}

TEST(FacetEdges, AreNoneWhereAllAreFaint)
{
  EXPECT_EQ(facetEdges(icosahedron(), { 42.0, 5.0, 36.0 }), 0U);
}

TEST(FacetEdges, OfAnOpenSurfaceAreNotItsBoundary)
{
  const SurfaceMesh triangle = shapes::triangleMesh(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0));
  EXPECT_EQ(facetEdges(triangle, 30.0, 0.1), 0U);
}
