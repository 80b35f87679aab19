// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/EdgeCollapsing.h"

#include "Mesh/MeshQuality.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/FaceShape.h"
#include "Remeshing/RemeshingShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{

using namespace evolving;
using namespace evolving::editing;

/// Guards that refuse nothing.
constexpr CollapseGuards Unguarded{ 1e9, -1.0, 0.0, 1e9 };

double longestEdge(const EditableSurface& surface)
{
  double longest = 0.0;
  for (const Index e : edgesOf(surface))
  {
    longest = std::max(longest, surface.length(e));
  }
  return longest;
}

double worstShape(const EditableSurface& surface)
{
  double worst = 1.0;
  for (Index f = 0; f < surface.faceSlots(); ++f)
  {
    if (surface.hasFace(f))
    {
      worst = std::min(
        worst, faceShape(surface.corner(f, 0), surface.corner(f, 1), surface.corner(f, 2)));
    }
  }
  return worst;
}

TEST(EdgeCollapsing, CountsWhatVanishes)
{
  EditableSurface surface = shapes::sized(icosphere(4), 0.3);
  const Index collapses = collapseShortEdges(surface, 0.8);
  EXPECT_GT(collapses, 2000);
  EXPECT_EQ(surface.mesh().vertexCount(), 2562 - collapses);
  expectSound(surface, { 2, 0, 1 });
  EXPECT_EQ(collapseShortEdges(surface, 0.8), 0); // it goes on until nothing is left to do
}

TEST(EdgeCollapsing, LeavesNoShortEdgeUnlessAGuardSaysSo)
{
  EditableSurface surface = shapes::sized(shapes::shakenSphere(4, 0.2, 1), 0.3);
  collapseShortEdges(surface, 0.8, Unguarded);
  for (const Index e : edgesOf(surface))
  {
    EXPECT_FALSE(shapes::relativeLength(surface, e) < 0.8 && surface.canCollapse(e));
  }
}

TEST(EdgeCollapsing, InnerVerticesMeetInTheMiddle)
{
  SurfaceMesh mesh = shapes::sheet(6, true);
  mesh.points[25] = mesh.points[24] + Vec3(0.02, 0.0, 0.0);
  EditableSurface surface = shapes::sized(mesh, 1.0 / 6.0);
  EXPECT_EQ(collapseShortEdges(surface, 0.3, Unguarded), 1);
  const Vec3 middle = mesh.points[24] + Vec3(0.01, 0.0, 0.0);
  EXPECT_LT((surface.point(shapes::vertexNear(surface, middle)) - middle).norm(), 1e-15);
}

TEST(EdgeCollapsing, NewEdgesAreNotTooLong)
{
  CollapseGuards guards = Unguarded;
  guards.longest = 1.1;
  EditableSurface surface = shapes::sized(shapes::shakenSphere(4, 0.2, 2), 0.3);
  ASSERT_LT(longestEdge(surface), 0.33);
  EXPECT_GT(collapseShortEdges(surface, 0.95, guards), 1000);
  EXPECT_LT(longestEdge(surface), 1.1 * 0.3);
  EditableSurface free = shapes::sized(shapes::shakenSphere(4, 0.2, 2), 0.3);
  collapseShortEdges(free, 0.95, Unguarded);
  EXPECT_GT(longestEdge(free), 1.1 * 0.3);
}

TEST(EdgeCollapsing, NewFacesHaveShape)
{
  CollapseGuards guards;
  guards.leastQuality = 0.6;
  EditableSurface surface = shapes::sized(shapes::shakenSphere(4, 0.1, 3), 0.3);
  ASSERT_GT(worstShape(surface), 0.6);
  EXPECT_GT(collapseShortEdges(surface, 0.8, guards), 1000);
  EXPECT_GE(worstShape(surface), 0.6);
}

TEST(EdgeCollapsing, BadFacesMayBecomeBetter)
{
  // A sliver below any bound vanishes, because what follows is better.
  SurfaceMesh mesh = shapes::sheet(6, true);
  mesh.points[25] = mesh.points[24] + Vec3(1e-6, 0.0, 0.0);
  EditableSurface surface = shapes::sized(mesh, 1.0 / 6.0);
  CollapseGuards guards;
  guards.longest = 2.5;
  guards.leastQuality = 0.99;
  const double before = worstShape(surface);
  EXPECT_EQ(collapseShortEdges(surface, 0.3, guards), 1);
  EXPECT_GT(worstShape(surface), 1e3 * before);
}

TEST(EdgeCollapsing, NormalsTurnLittle)
{
  // A thin box: without a guard collapses round its edges off, with one they do not.
  const SurfaceMesh box = shapes::triangleBox(8, Vec3(1.0, 1.0, 0.1));
  EditableSurface surface = shapes::sized(box, 0.5);
  CollapseGuards strict = Unguarded;
  strict.leastCosine = 0.999;
  EXPECT_GT(collapseShortEdges(surface, 0.8, strict), 50);
  for (Index f = 0; f < surface.faceSlots(); ++f)
  {
    if (surface.hasFace(f))
    {
      EXPECT_GT(surface.doubleArea(f).normalized().cwiseAbs().maxCoeff(), 0.99);
    }
  }
}

TEST(EdgeCollapsing, CurvesAndTheirEndsStay)
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

TEST(EdgeCollapsing, WhereACurveBecomesAnotherAVertexStays)
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

TEST(EdgeCollapsing, ABoundaryKeepsItsCorners)
{
  EditableSurface sheet = shapes::sized(shapes::sheet(12, true), 0.25);
  EXPECT_GT(collapseShortEdges(sheet, 0.8), 80);
  expectSound(sheet, { 1, 1, 1 });
  EXPECT_NEAR(surfaceArea(sheet.mesh()), 1.0, 1e-14);
}

TEST(EdgeCollapsing, ABoundaryIsCutLittle)
{
  // Circles of ever fewer vertices: each cut is at most a tenth of the size deep.
  const double size = 0.3;
  EditableSurface disc = shapes::sized(shapes::disc(20), size);
  EXPECT_GT(collapseShortEdges(disc, 0.8), 1000);
  EXPECT_GT(surfaceArea(disc.mesh()), shapes::Pi * (1.0 - 0.1 * size) * (1.0 - 0.1 * size));
}

TEST(EdgeCollapsing, BothEndsOfABoundaryEdgeCanStay)
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

TEST(EdgeCollapsing, PinnedVerticesStay)
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

TEST(EdgeCollapsing, WhatDoesNotChangeIsNotJudged)
{
  // A short edge into a pinned vertex that has slivers on its other side.
  SurfaceMesh mesh = shapes::sheet(6, true);
  mesh.points[23] = mesh.points[24] - Vec3(0.004, 0.0, 0.0);
  mesh.points[25] = mesh.points[24] + Vec3(0.1, 0.0, 0.0);
  EditableSurface surface = shapes::sized(mesh, 0.2);
  surface.setPinned(24);
  surface.setPinned(23);
  CollapseGuards guards;
  guards.longest = 1.95;
  EXPECT_EQ(collapseShortEdges(surface, 0.6, guards), 1);
  EXPECT_FALSE(surface.hasVertex(25));
}

TEST(EdgeCollapsing, FewNeighboursAreNone)
{
  EditableSurface surface = shapes::sized(icosphere(2), 0.3);
  Index added = 0;
  for (Index f = 0; f < 320; f += 20)
  {
    // A vertex in the middle of a face: split an edge, and turn what joins it to the far apex.
    const Index e = 3 * f;
    const Index from = surface.from(e);
    const Vec3 centre = (surface.corner(f, 0) + surface.corner(f, 1) + surface.corner(f, 2)) / 3.0;
    const Index m = surface.split(e, centre);
    const Index far = surface.apex(surface.opposite(edgeBetween(surface, from, m)));
    surface.flip(edgeBetween(surface, m, far));
    ASSERT_EQ(surface.valence(m), 3);
    ++added;
  }
  EXPECT_EQ(collapseLowValences(surface), added);
  expectSound(surface, { 2, 0, 1 });
  for (const Index v : verticesOf(surface))
  {
    EXPECT_GE(surface.valence(v), 5);
  }
  EXPECT_EQ(surface.mesh().vertexCount(), 162);
}

} // namespace
