// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/StageGuard.h"

#include "Mesh/SelfIntersections.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/RemeshingShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using namespace evolving;
using namespace evolving::editing;

/// A slab of thickness 0.1, its top and bottom of 16 x 16 squares.
EditableSurface slab()
{
  return shapes::sized(shapes::triangleBox(16, Vec3(1.0, 1.0, 0.05)), 0.125);
}

/// Lifts the top by a bit, and pushes one vertex of it through the bottom.
void liftAndPush(EditableSurface& surface, bool respectsLocks)
{
  const Index pushed = shapes::vertexNear(surface, Vec3(0.5, 0.5, 0.05));
  for (const Index v : verticesOf(surface))
  {
    if (surface.point(v).z() > 0.0 && !(respectsLocks && surface.isPinned(v)))
    {
      surface.setPoint(v, surface.point(v) + Vec3(0.0, 0.0, v == pushed ? -0.2 : 0.01));
    }
  }
}

TEST(StageGuard, LetsAStageThatIntersectsNothingPass)
{
  EditableSurface surface = slab();
  const auto lift = [](EditableSurface& s)
  {
    for (const Index v : verticesOf(s))
    {
      s.setPoint(v, s.point(v) + Vec3(0.0, 0.0, 0.1));
    }
  };
  EditableSurface expected = surface;
  lift(expected);
  EXPECT_EQ(runGuarded(surface, lift), 0);
  EXPECT_TRUE(surface.mesh() == expected.mesh());
}

TEST(StageGuard, UndoesAPlaceAndKeepsTheRest)
{
  EditableSurface surface = slab();
  const EditableSurface before = surface;
  int runs = 0;
  const Index made = runGuarded(surface,
    [&](EditableSurface& s)
    {
      ++runs;
      liftAndPush(s, true);
    });
  EXPECT_GT(made, 0);
  EXPECT_EQ(runs, 2);
  EXPECT_TRUE(selfIntersections(surface.mesh()).empty());
  Index moved = 0;
  Index top = 0;
  for (const Index v : verticesOf(surface))
  {
    const double rise = surface.point(v).z() - before.point(v).z();
    const double distance = (before.point(v) - Vec3(0.5, 0.5, 0.05)).norm();
    EXPECT_FALSE(surface.isPinned(v)) << "a lock is left";
    if (before.point(v).z() > 0.0)
    {
      // Locked are two sizes around the faces that intersected: a vertex's ring, one edge more.
      EXPECT_TRUE(distance > 0.26 || rise == 0.0);
      EXPECT_TRUE(distance < 0.5 || std::abs(rise - 0.01) < 1e-15);
      moved += rise != 0.0 ? 1 : 0;
      ++top;
    }
  }
  EXPECT_GT(moved, 0.7 * top);
}

TEST(StageGuard, OfMovesOnlyThoseThatIntersectAreTakenBack)
{
  EditableSurface surface = slab();
  const EditableSurface before = surface;
  int runs = 0;
  const Index back = runMoves(surface,
    [&](EditableSurface& s)
    {
      ++runs;
      liftAndPush(s, false);
    });
  EXPECT_EQ(runs, 1);
  EXPECT_TRUE(selfIntersections(surface.mesh()).empty());
  Index stayed = 0;
  for (const Index v : verticesOf(surface))
  {
    const double rise = surface.point(v).z() - before.point(v).z();
    if (before.point(v).z() > 0.0)
    {
      EXPECT_TRUE(rise == 0.0 || std::abs(rise - 0.01) < 1e-15);
      stayed += rise == 0.0 ? 1 : 0;
    }
  }
  // The vertex that was pushed, and no more than its ring.
  EXPECT_GT(stayed, 0);
  EXPECT_LE(stayed, 9);
  EXPECT_GE(back, stayed);
}

TEST(StageGuard, LeavesAStageOutThatAlwaysIntersects)
{
  EditableSurface surface = slab();
  surface.setPinned(3);
  const Content before(surface);
  const SurfaceMesh mesh = surface.mesh();
  int runs = 0;
  EXPECT_GT(runGuarded(surface,
              [&](EditableSurface& s)
              {
                ++runs;
                liftAndPush(s, false);
              }),
    0);
  EXPECT_EQ(runs, 5);
  EXPECT_TRUE(surface.mesh() == mesh);
  EXPECT_TRUE(Content(surface) == before);
}

TEST(StageGuard, GuardsChangesOfConnectivityToo)
{
  // A stage that collapses the slab's rim until its sides meet, unless locked.
  EditableSurface surface = slab();
  const Kind kind = kindOf(surface.mesh());
  runGuarded(surface,
    [](EditableSurface& s)
    {
      for (Index e = 0; e < s.edgeSlots(); ++e)
      {
        if (s.hasEdge(e) && s.canCollapse(e) && !s.isPinned(s.from(e)) && !s.isPinned(s.to(e)) &&
          e % 3 == 0)
        {
          s.collapse(e);
        }
      }
      liftAndPush(s, true);
    });
  expectSound(surface, kind);
  EXPECT_TRUE(selfIntersections(surface.mesh()).empty());
}

TEST(UndoIntersections, TakesBackWhatIntersects)
{
  SurfaceMesh mesh = slab().mesh();
  const std::vector<Vec3> before = mesh.points;
  EditableSurface moved = slab();
  liftAndPush(moved, false);
  mesh.points = moved.mesh().points;
  ASSERT_FALSE(selfIntersections(mesh).empty());
  const Index back = undoIntersections(mesh, before);
  EXPECT_TRUE(selfIntersections(mesh).empty());
  Index found = 0;
  Index still = 0;
  for (std::size_t v = 0; v < before.size(); ++v)
  {
    const bool isAsBefore = mesh.points[v] == before[v];
    const bool wasMoved = before[v].z() > 0.0;
    EXPECT_TRUE(isAsBefore || mesh.points[v] == moved.point(static_cast<Index>(v)));
    found += isAsBefore && wasMoved ? 1 : 0;
    still += !isAsBefore ? 1 : 0;
  }
  EXPECT_GE(back, found); // vertices of the bottom are counted too, which had not moved
  EXPECT_LT(found, 30);
  EXPECT_GT(still, 200);
}

TEST(UndoIntersections, EndsWhereTheSurfaceIntersectedBefore)
{
  EditableSurface pushed = slab();
  liftAndPush(pushed, false);
  SurfaceMesh mesh = pushed.mesh();
  const SurfaceMesh before = mesh;
  undoIntersections(mesh, before.points);
  EXPECT_TRUE(mesh == before);
}

TEST(UndoIntersections, LeavesASoundSurfaceAlone)
{
  SurfaceMesh mesh = icosphere(3);
  const std::vector<Vec3> before = icosphere(3, 2.0).points;
  EXPECT_EQ(undoIntersections(mesh, before), 0);
  EXPECT_TRUE(mesh == icosphere(3));
}

} // namespace
