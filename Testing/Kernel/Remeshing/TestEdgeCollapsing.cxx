// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/EdgeCollapsing.h"

#include "Mesh/MeshQuality.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/FaceShape.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace
{

using namespace evolving;
using namespace evolving::editing;

/// Guards that refuse nothing.
constexpr CollapseLimits Unguarded{ 1e9, -1.0, 0.0, 1e9 };

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

/// Every edge is tried in every sweep, whatever has changed.
void collapseAll(EditableSurface& surface, double ratio, const CollapseLimits& guards)
{
  for (bool hasChanged = true; hasChanged;)
  {
    hasChanged = false;
    std::vector<std::pair<double, Index>> edges;
    for (const Index e : edgesOf(surface))
    {
      if (surface.isFirstHalf(e) && shapes::relativeLength(surface, e) < ratio)
      {
        edges.emplace_back(shapes::relativeLength(surface, e), e);
      }
    }
    std::sort(edges.begin(), edges.end());
    for (const auto& [length, e] : edges)
    {
      hasChanged = (surface.hasEdge(e) && shapes::relativeLength(surface, e) < ratio &&
                     collapseEdge(surface, e, guards)) ||
        hasChanged;
    }
  }
}

TEST(EdgeCollapsing, LeavesOutOnlyTriesThatWouldFailAgain)
{
  CollapseLimits strict;
  strict.leastQuality = 0.6;
  std::vector<EditableSurface> surfaces{ shapes::sized(shapes::shakenSphere(4, 0.3, 2), 0.2),
    shapes::sized(shapes::triangleBox(12, Vec3(0.5, 0.5, 0.5)), 0.3),
    shapes::sized(shapes::shakenInside(shapes::halfSphere(24), 0.01, 7), 0.3) };
  shapes::markCreases(surfaces[1]);
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    surfaces.push_back(shapes::sized(shapes::shakenSphere(3, 0.4, seed), 0.5));
  }
  for (EditableSurface& surface : surfaces)
  {
    for (Index v = 0; v < surface.vertexSlots(); v += 11)
    {
      surface.setPinned(v);
    }
    EditableSurface expected = surface;
    collapseAll(expected, 0.8, strict);
    EXPECT_GT(collapseShortEdges(surface, 0.8, strict), 100);
    EXPECT_EQ(surface.mesh().points, expected.mesh().points);
    EXPECT_EQ(surface.mesh().cornerVertices, expected.mesh().cornerVertices);
  }
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
  CollapseLimits guards = Unguarded;
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
  CollapseLimits guards;
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
  CollapseLimits guards;
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
  CollapseLimits strict = Unguarded;
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

TEST(EdgeCollapsing, WhatDoesNotChangeIsNotJudged)
{
  // A short edge into a pinned vertex that has slivers on its other side.
  SurfaceMesh mesh = shapes::sheet(6, true);
  mesh.points[23] = mesh.points[24] - Vec3(0.004, 0.0, 0.0);
  mesh.points[25] = mesh.points[24] + Vec3(0.1, 0.0, 0.0);
  EditableSurface surface = shapes::sized(mesh, 0.2);
  surface.setPinned(24);
  surface.setPinned(23);
  CollapseLimits guards;
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
