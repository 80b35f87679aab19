// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/EdgeSplitting.h"

#include "Remeshing/EditingChecks.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace
{

using namespace evolving;
using namespace evolving::editing;

TEST(EdgeSplitting, LeavesNoLongEdge)
{
  for (const SurfaceMesh& mesh :
    { icosphere(1), shapes::torus(12, 5, 2.0, 0.5), shapes::shakenSheet(4, true, 0.3, 1),
      shapes::tube(7, 3, 2.0, [](double) { return 1.0; }) })
  {
    for (const double ratio : { 1.0, 4.0 / 3.0, 1.5 })
    {
      EditableSurface surface = shapes::sized(mesh, 0.11);
      const Kind kind = kindOf(mesh);
      const Index splits = splitLongEdges(surface, ratio);
      expectSound(surface, kind);
      EXPECT_LE(shapes::relativeLengths(surface).longest, ratio);
      EXPECT_EQ(surface.vertexSlots(), mesh.vertexCount() + splits);
      EXPECT_EQ(splitLongEdges(surface, ratio), 0);
    }
  }
}

TEST(EdgeSplitting, KeepsTheSurfaceWhereItIs)
{
  const SurfaceMesh mesh = shapes::ellipsoid(1, Vec3(1.0, 2.0, 3.0));
  EditableSurface surface = shapes::sized(mesh, 0.2);
  splitLongEdges(surface, 4.0 / 3.0);
  EXPECT_NEAR(surfaceArea(surface.mesh()), surfaceArea(mesh), 1e-11);
  EXPECT_NEAR(signedVolume(surface.mesh()), signedVolume(mesh), 1e-11);
}

TEST(EdgeSplitting, SplitsLongEdgesOnly)
{
  // One long edge in a sheet of short ones: its two faces are cut once, no other.
  SurfaceMesh mesh = shapes::sheet(6, true);
  EditableSurface surface = shapes::sized(mesh, 0.2);
  const Index longest = edgeBetween(surface, 24, 32);
  surface.setSize(24, 0.12);
  surface.setSize(32, 0.12);
  ASSERT_GT(shapes::relativeLength(surface, longest), 1.8);
  EXPECT_EQ(splitLongEdges(surface, 1.8), 1);
  EXPECT_LT((surface.point(49) - Vec3(0.5, 0.5, 0) - Vec3(0.5, 0.5, 0) / 6.0).norm(), 1e-15);
}

TEST(EdgeSplitting, TwoLongEdgesOfAFaceAreTwoSplits)
{
  // The edge that the first split leaves inside is short: it stays.
  SurfaceMesh mesh;
  mesh.points = { Vec3::Zero(), Vec3(2.0, 0.0, 0.0), Vec3(0.35, 0.94, 0.0) };
  mesh.addFace({ 0, 1, 2 });
  EditableSurface surface = shapes::sized(mesh, 1.0);
  EXPECT_EQ(splitLongEdges(surface, 1.5), 2);
  ASSERT_EQ(surface.vertexSlots(), 5);
  EXPECT_LT((surface.point(3) - Vec3(1.0, 0.0, 0.0)).norm(), 1e-15); // the longest first
  EXPECT_LT((surface.point(4) - Vec3(1.175, 0.47, 0.0)).norm(), 1e-15);
}

TEST(EdgeSplitting, NoSplitIsInVain)
{
  // Equal edges, each too long once; what is new between their middles is not.
  EditableSurface surface = shapes::sized(icosphere(0), 0.725);
  EXPECT_EQ(splitLongEdges(surface, 4.0 / 3.0), 30);
}

TEST(EdgeSplitting, SizesOfNewVerticesAreMeans)
{
  EditableSurface surface(icosphere(1));
  for (const Index v : verticesOf(surface))
  {
    surface.setSize(v, 0.2 + 0.1 * surface.point(v).z());
  }
  splitLongEdges(surface, 4.0 / 3.0);
  for (const Index v : verticesOf(surface))
  {
    EXPECT_NEAR(surface.size(v), 0.2 + 0.1 * surface.point(v).z(), 1e-14);
  }
  EXPECT_LE(shapes::relativeLengths(surface).longest, 4.0 / 3.0);
}

TEST(EdgeSplitting, CreasesAndLabelsAreHalvedToo)
{
  EditableSurface box = shapes::sized(shapes::triangleBox(2, Vec3(1.0, 1.0, 1.0)), 0.3);
  shapes::markCreases(box);
  double length = 0.0;
  splitLongEdges(box, 4.0 / 3.0);
  for (const Index e : edgesOf(box))
  {
    const Vec3 a = box.point(box.from(e)).cwiseAbs();
    const Vec3 b = box.point(box.to(e)).cwiseAbs();
    const bool isOnCrease = ((a.array() == 1.0) && (b.array() == 1.0)).count() == 2;
    ASSERT_EQ(box.curve(e), isOnCrease ? 0 : NoIndex);
    length += isOnCrease && box.isFirstHalf(e) ? box.length(e) : 0.0;
  }
  EXPECT_NEAR(length, 24.0, 1e-12);
}

TEST(EdgeSplitting, LockedFacesStay)
{
  EditableSurface surface = shapes::sized(icosphere(2), 0.1);
  const auto isHigh = [&](Index v) { return surface.point(v).z() > 0.3; };
  for (const Index v : verticesOf(surface))
  {
    if (isHigh(v))
    {
      surface.setLocked(v);
    }
  }
  const auto lockedFaces = [](const EditableSurface& s)
  {
    std::set<std::array<Place, 3>> faces;
    for (Index f = 0; f < s.faceSlots(); ++f)
    {
      if (s.hasFace(f) && s.isLockedFace(f))
      {
        faces.insert({ placeOf(s.corner(f, 0)), placeOf(s.corner(f, 1)), placeOf(s.corner(f, 2)) });
      }
    }
    return faces;
  };
  const auto before = lockedFaces(surface);
  ASSERT_GT(before.size(), 50U);
  EXPECT_GT(splitLongEdges(surface, 4.0 / 3.0), 200);
  EXPECT_TRUE(lockedFaces(surface) == before);
  expectSound(surface, { 2, 0, 1 });
}

} // namespace
