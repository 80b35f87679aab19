// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/Angles.h"
#include "Remeshing/EdgeCollapsing.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{

using namespace evolving;
using namespace evolving::editing;

/// Guards that refuse nothing.
constexpr CollapseLimits Unguarded{ 1e9, -1.0, 0.0, 1e9 };

TEST(CollapseLimits, CurvesAndTheirEndsStay)
{
  const Vec3 half(1.0, 0.8, 0.6);
  EditableSurface box = shapes::sized(shapes::triangleBox(10, half), 0.4);
  shapes::markCreases(box);
  EXPECT_GT(collapseShortEdges(box, 0.8), 300);
  expectSound(box, { 2, 0, 1 });
  // The box is the same set of points: corners, creases and sides are where they were.
  EXPECT_NEAR(signedVolume(box.mesh()), 8.0 * half.prod(), 1e-12);
  double length = 0.0;
  for (const Index e : edgesOf(box))
  {
    length += box.isFirstHalf(e) && box.isFeature(e) ? box.length(e) : 0.0;
  }
  EXPECT_NEAR(length, 8.0 * half.sum(), 1e-12);
}

TEST(CollapseLimits, WhereACurveBecomesAnotherAVertexStays)
{
  // A straight line of edges through a sheet, curve 1 and then curve 2.
  for (const Index ones : { 3, 4, 5, 6, 7 })
  {
    EditableSurface sheet = shapes::sized(shapes::sheet(12, true), 0.25);
    for (Index i = 0; i < 12; ++i)
    {
      sheet.setCurve(edgeBetween(sheet, 78 + i, 79 + i), i < ones ? 1 : 2);
    }
    EXPECT_GT(collapseShortEdges(sheet, 0.8), 50);
    double first = 0.0;
    for (const Index e : edgesOf(sheet))
    {
      first += sheet.isFirstHalf(e) && sheet.curve(e) == 1 ? sheet.length(e) : 0.0;
    }
    EXPECT_NEAR(first, ones / 12.0, 1e-14);
  }
}

TEST(CollapseLimits, ABoundaryKeepsItsCorners)
{
  EditableSurface sheet = shapes::sized(shapes::sheet(12, true), 0.25);
  EXPECT_GT(collapseShortEdges(sheet, 0.8), 80);
  expectSound(sheet, { 1, 1, 1 });
  EXPECT_NEAR(surfaceArea(sheet.mesh()), 1.0, 1e-14);
}

TEST(CollapseLimits, ABoundaryIsCutLittle)
{
  // Circles of ever fewer vertices: each cut is at most a tenth of the size deep.
  const double size = 0.3;
  EditableSurface disc = shapes::sized(shapes::disc(20), size);
  EXPECT_GT(collapseShortEdges(disc, 0.8), 1000);
  EXPECT_GT(surfaceArea(disc.mesh()), Pi * (1.0 - 0.1 * size) * (1.0 - 0.1 * size));
}

TEST(CollapseLimits, BothEndsOfABoundaryEdgeCanStay)
{
  // Each boundary edge has one half-edge, whichever of its ends is pinned.
  for (const Index pinned : { 0, 1 })
  {
    SurfaceMesh mesh = shapes::sheet(4, true);
    mesh.points[2].x() = 0.3;
    EditableSurface sheet = shapes::sized(mesh, 0.25);
    sheet.setPinned(1 + pinned);
    sheet.setSize(1 + pinned, 0.2);
    EXPECT_EQ(collapseShortEdges(sheet, 0.5, Unguarded), 1);
    const Index kept = shapes::vertexNear(sheet, mesh.points[static_cast<std::size_t>(1 + pinned)]);
    EXPECT_EQ(sheet.point(kept), mesh.points[static_cast<std::size_t>(1 + pinned)]);
    EXPECT_TRUE(sheet.isPinned(kept));
    EXPECT_EQ(sheet.size(kept), 0.2);
    expectSound(sheet, { 1, 1, 1 });
  }
}

TEST(CollapseLimits, PinnedVerticesStay)
{
  EditableSurface surface = shapes::sized(icosphere(3), 0.5);
  std::vector<Vec3> pinned;
  for (Index v = 0; v < surface.vertexSlots(); v += 40)
  {
    surface.setPinned(v);
    pinned.push_back(surface.point(v));
  }
  EXPECT_GT(collapseShortEdges(surface, 0.8), 300);
  for (const Vec3& point : pinned)
  {
    const Index v = shapes::vertexNear(surface, point);
    EXPECT_TRUE(surface.isPinned(v));
    EXPECT_EQ((surface.point(v) - point).norm(), 0.0);
  }
}

} // namespace
