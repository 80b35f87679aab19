// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/EditableSurface.h"

#include "Errors.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{

using namespace evolving;

using namespace evolving::shapes;
using namespace evolving::editing;

TEST(EditableSurface, RefusesOtherThanTriangles)
{
  EXPECT_THROW(EditableSurface{ unitCube() }, InputError);
}

TEST(EditableSurface, RefusesNonManifolds)
{
  SurfaceMesh fins = cornerTetrahedron();
  const Index tip = fins.addPoint(Vec3(0.3, 0.3, 5.0));
  fins.addFace({ 0, 1, tip });
  EXPECT_THROW(EditableSurface{ fins }, InputError);
  EXPECT_THROW(EditableSurface{ moebiusBand(8) }, InputError);
}

TEST(EditableSurface, GivesTheMeshBack)
{
  for (const SurfaceMesh& mesh :
    { icosphere(2), shapes::torus(9, 6, 2.0, 0.7), shapes::sheet(4, true) })
  {
    const EditableSurface surface(mesh);
    expectSound(surface, kindOf(mesh));
    EXPECT_TRUE(surface.mesh() == mesh);
  }
}

TEST(EditableSurface, LeavesUnusedPointsOut)
{
  SurfaceMesh mesh = icosphere(1);
  mesh.points.insert(mesh.points.begin(), Vec3(9.0, 9.0, 9.0));
  for (Index& v : mesh.cornerVertices)
  {
    ++v;
  }
  EditableSurface surface(mesh);
  EXPECT_FALSE(surface.hasVertex(0));
  EXPECT_TRUE(surface.mesh() == icosphere(1));
  surface.compact();
  EXPECT_EQ(surface.vertexSlots(), 42);
  expectSound(surface, { 2, 0, 1 });
}

TEST(EditableSurface, KnowsNeighboursAndValences)
{
  const EditableSurface disc(shapes::disc(3));
  EXPECT_EQ(disc.valence(0), 6);
  EXPECT_FALSE(disc.isBoundary(0));
  Index boundary = 0;
  for (const Index v : verticesOf(disc))
  {
    boundary += disc.isBoundary(v) ? 1 : 0;
    EXPECT_EQ(disc.featureEdges(v), disc.isBoundary(v) ? 2 : 0);
    disc.forEachNeighbour(v, [&](Index u) { EXPECT_TRUE(disc.areNeighbours(u, v)); });
  }
  EXPECT_EQ(boundary, 18);
  EXPECT_NEAR((disc.normal(0) - Vec3::UnitZ()).norm(), 0.0, 1e-15);
}

TEST(EditableSurface, SplitPutsAVertexOnAnEdge)
{
  EditableSurface sheet(shapes::sheet(1, true));
  const Index diagonal = edgeBetween(sheet, 0, 3);
  ASSERT_NE(diagonal, NoIndex);
  const Index inner = sheet.split(diagonal, Vec3(0.5, 0.5, 0.0));
  expectSound(sheet, { 1, 1, 1 });
  EXPECT_EQ(sheet.valence(inner), 4);
  EXPECT_FALSE(sheet.isBoundary(inner));
  const Index outer = sheet.split(edgeBetween(sheet, 0, 1), Vec3(0.5, 0.0, 0.0));
  expectSound(sheet, { 1, 1, 1 });
  EXPECT_EQ(sheet.valence(outer), 3);
  EXPECT_TRUE(sheet.isBoundary(outer));
  EXPECT_DOUBLE_EQ(surfaceArea(sheet.mesh()), 1.0);
}

TEST(EditableSurface, FlipJoinsTheApexes)
{
  EditableSurface sheet(shapes::shakenSheet(4, true, 0.2, 3));
  const double area = surfaceArea(sheet.mesh());
  const Index diagonal = edgeBetween(sheet, 6, 12);
  ASSERT_TRUE(sheet.canFlip(diagonal));
  const Index c = sheet.apex(diagonal);
  const Index d = sheet.apex(sheet.opposite(diagonal));
  sheet.flip(diagonal);
  expectSound(sheet, { 1, 1, 1 });
  EXPECT_FALSE(sheet.areNeighbours(6, 12));
  EXPECT_TRUE(sheet.areNeighbours(c, d));
  EXPECT_NEAR(surfaceArea(sheet.mesh()), area, 1e-14);
}

TEST(EditableSurface, FlipMayLeaveACornerOneFace)
{
  // The diagonal of a square that ends in two of its corners can be the other one.
  SurfaceMesh mesh = shapes::sheet(2, true);
  EditableSurface sheet(mesh);
  const Index diagonal = edgeBetween(sheet, 0, 4);
  ASSERT_TRUE(sheet.canFlip(diagonal));
  sheet.flip(diagonal);
  expectSound(sheet, { 1, 1, 1 });
  EXPECT_EQ(sheet.valence(0), 2);
}

TEST(EditableSurface, CompactChangesNumbersOnly)
{
  EditableSurface surface(shapes::shakenSheet(8, true, 0.2, 5));
  for (const Index v : verticesOf(surface))
  {
    surface.setSize(v, 1.0 + v);
    surface.setGuess(v, 3 * v);
    if (v % 5 == 0)
    {
      surface.setPinned(v);
    }
    if (v % 7 == 0)
    {
      surface.setLocked(v);
    }
  }
  for (const Index e : edgesOf(surface))
  {
    surface.setLabel(EditableSurface::faceOf(e), e / 3 % 4);
    if (surface.isFirstHalf(e) && e % 11 == 0)
    {
      surface.setCurve(e, e);
    }
  }
  for (Index e = 0; e < surface.edgeSlots(); e += 7)
  {
    if (surface.hasEdge(e) && surface.canCollapse(e))
    {
      surface.collapse(e);
    }
  }
  const SurfaceMesh mesh = surface.mesh();
  const Content content(surface);
  ASSERT_LT(mesh.vertexCount(), surface.vertexSlots());
  surface.compact();
  expectSound(surface, { 1, 1, 1 });
  EXPECT_TRUE(surface.mesh() == mesh);
  EXPECT_TRUE(Content(surface) == content);
  EXPECT_EQ(surface.vertexSlots(), mesh.vertexCount());
  EXPECT_EQ(surface.faceSlots(), mesh.faceCount());
}

TEST(EditableSurface, LocksArePinsThatCanBeReleased)
{
  EditableSurface surface(icosphere(1));
  surface.setPinned(1);
  surface.setLocked(2);
  surface.setLocked(1);
  EXPECT_TRUE(surface.isPinned(2) && surface.isLocked(2) && surface.isLocked(1));
  surface.releaseLocks();
  EXPECT_TRUE(surface.isPinned(1));
  EXPECT_FALSE(surface.isLocked(1) || surface.isPinned(2) || surface.isLocked(2));
}

TEST(EditableSurface, OnlyFacesBetweenThreeLocksAreLocked)
{
  EditableSurface surface(icosphere(0));
  surface.setLocked(surface.from(0));
  surface.setLocked(surface.from(1));
  EXPECT_FALSE(surface.isLockedFace(0));
  surface.setLocked(surface.from(2));
  EXPECT_TRUE(surface.isLockedFace(0));
  for (Index k = 0; k < 3; ++k)
  {
    EXPECT_FALSE(surface.canFlip(k));
  }
}

} // namespace
