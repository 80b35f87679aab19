// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/IntersectionFreeStages.h"

#include "Mesh/MeshQuality.h"
#include "Mesh/SelfIntersections.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/FaceShape.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"

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

/// Lifts the top by a bit, and pushes what is near a point of it through the bottom.
void liftAndPush(EditableSurface& surface, double reach, bool respectsLocks)
{
  for (const Index v : verticesOf(surface))
  {
    if (surface.point(v).z() > 0.0 && !(respectsLocks && surface.isPinned(v)))
    {
      const bool isPushed = (surface.point(v) - Vec3(0.5, 0.5, 0.05)).norm() < reach;
      surface.setPoint(v, surface.point(v) + Vec3(0.0, 0.0, isPushed ? -0.2 : 0.01));
    }
  }
}

constexpr double OneVertex = 0.01;
constexpr double ManyVertices = 0.26;

TEST(IntersectionFreeStages, LetsAStageThatIntersectsNothingPass)
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
  EXPECT_EQ(runWithoutIntersections(surface, lift).intersections, 0);
  EXPECT_TRUE(surface.mesh() == expected.mesh());
}

TEST(IntersectionFreeStages, SmoothsAPlaceAndKeepsTheRest)
{
  EditableSurface surface = slab();
  EditableSurface once = surface;
  liftAndPush(once, OneVertex, false);
  int runs = 0;
  const StageRuns outcome = runWithoutIntersections(surface,
    [&](EditableSurface& s)
    {
      ++runs;
      liftAndPush(s, OneVertex, false);
    });
  EXPECT_FALSE(outcome.isLeftOut);
  EXPECT_EQ(outcome.intersections, static_cast<Index>(selfIntersections(once.mesh()).size()));
  EXPECT_EQ(runs, 1);
  EXPECT_TRUE(selfIntersections(surface.mesh()).empty());
  for (const Index v : verticesOf(surface))
  {
    // A ring around the vertex that was pushed, on both sides.
    const Vec3 fromPush = once.point(v) - Vec3(0.5, 0.5, 0.0);
    const bool isNear = fromPush.head<2>().norm() < 0.3;
    EXPECT_TRUE(isNear || surface.point(v) == once.point(v));
  }
}

TEST(IntersectionFreeStages, UndoesAPlaceAndKeepsTheRest)
{
  EditableSurface surface = slab();
  const EditableSurface before = surface;
  int runs = 0;
  const StageRuns outcome = runWithoutIntersections(surface,
    [&](EditableSurface& s)
    {
      ++runs;
      liftAndPush(s, ManyVertices, true);
    });
  EXPECT_GT(outcome.intersections, 0);
  EXPECT_FALSE(outcome.isLeftOut);
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
      // Locked is what is next to the faces that intersected, those at the pushed vertices; not
      // what is many sizes away.
      EXPECT_TRUE(distance > ManyVertices + 0.125 || rise == 0.0);
      EXPECT_TRUE(distance < 0.85 || std::abs(rise - 0.01) < 1e-15);
      moved += rise != 0.0 ? 1 : 0;
      ++top;
    }
  }
  EXPECT_GT(moved, 0.5 * top);
}

TEST(IntersectionFreeStages, TakesBackSmallAnglesWhenAsked)
{
  // Moves vertices within their rings, nearly onto a neighbour: slivers, but nothing intersects.
  const auto squash = [](EditableSurface& s)
  {
    for (const Index v : { 100, 300 })
    {
      Index neighbour = NoIndex;
      s.forEachNeighbour(v, [&](Index u) { neighbour = u; });
      if (!s.isLocked(v))
      {
        s.setPoint(v, 0.05 * s.point(v) + 0.95 * s.point(neighbour));
      }
    }
  };
  const auto smallAngles = [](const EditableSurface& s)
  {
    Index count = 0;
    for (Index f = 0; f < s.faceSlots(); ++f)
    {
      count += smallestAngle(s.corner(f, 0), s.corner(f, 1), s.corner(f, 2)) < 10.0 ? 1 : 0;
    }
    return count;
  };
  const EditableSurface sphere = shapes::sized(shapes::shakenSphere(3, 0.0, 1), 0.15);
  const SurfaceMesh before = sphere.mesh();
  EditableSurface surface = sphere;
  EXPECT_EQ(runWithoutIntersections(surface, squash).intersections, 0);
  EXPECT_GT(smallAngles(surface), 2);
  surface = sphere;
  EXPECT_EQ(runWithoutIntersections(surface, squash, {}, 10.0).intersections, 0);
  EXPECT_EQ(smallAngles(surface), 0);
  EXPECT_TRUE(surface.mesh() == before);
}

/// Squashes triangles beside what is locked, or at some vertices where nothing is.
Index squashBesideLocks(EditableSurface& surface)
{
  const std::vector<Index> vertices = verticesOf(surface);
  const bool isLocked =
    std::any_of(vertices.begin(), vertices.end(), [&](Index v) { return surface.isLocked(v); });
  Index count = 0;
  for (const Index v : vertices)
  {
    Index neighbour = NoIndex;
    surface.forEachNeighbour(
      v, [&](Index u) { neighbour = !isLocked || surface.isLocked(u) ? u : neighbour; });
    const bool isWanted = isLocked ? neighbour != NoIndex : v == 100 || v == 300;
    if (isWanted && !surface.isLocked(v))
    {
      surface.setPoint(v, 0.05 * surface.point(v) + 0.95 * surface.point(neighbour));
      ++count;
    }
  }
  return count;
}

TEST(IntersectionFreeStages, EndsWhereLocksMakeAsManySmallAngles)
{
  EditableSurface surface = shapes::sized(shapes::shakenSphere(3, 0.0, 1), 0.15);
  const SurfaceMesh before = surface.mesh();
  std::vector<Index> squashed;
  const StageRuns outcome = runWithoutIntersections(
    surface, [&](EditableSurface& s) { squashed.push_back(squashBesideLocks(s)); }, {}, 10.0);
  ASSERT_EQ(squashed.size(), 2U);
  EXPECT_GT(squashed.back(), squashed.front());
  EXPECT_TRUE(outcome.isLeftOut);
  EXPECT_TRUE(surface.mesh() == before);
}

TEST(IntersectionFreeStages, OfMovesOnlyThoseThatIntersectAreTakenBack)
{
  EditableSurface surface = slab();
  const EditableSurface before = surface;
  int runs = 0;
  const Index back = moveWithoutIntersections(surface,
    [&](EditableSurface& s)
    {
      ++runs;
      liftAndPush(s, OneVertex, false);
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

TEST(IntersectionFreeStages, LeavesAStageOutThatAlwaysIntersects)
{
  EditableSurface surface = slab();
  surface.setPinned(3);
  const Content before(surface);
  const SurfaceMesh mesh = surface.mesh();
  int runs = 0;
  const StageRuns outcome = runWithoutIntersections(surface,
    [&](EditableSurface& s)
    {
      ++runs;
      liftAndPush(s, ManyVertices, false);
    });
  EXPECT_GT(outcome.intersections, 0);
  EXPECT_TRUE(outcome.isLeftOut);
  EXPECT_LT((outcome.place - Vec3(0.5, 0.5, 0.0)).head<2>().norm(), ManyVertices + 0.25);
  EXPECT_GT(runs, 1); // it was tried again
  EXPECT_TRUE(surface.mesh() == mesh);
  EXPECT_TRUE(Content(surface) == before);
}

TEST(IntersectionFreeStages, GuardsChangesOfConnectivityToo)
{
  // A stage that collapses the slab's rim until its sides meet, unless locked.
  EditableSurface surface = slab();
  const Kind kind = kindOf(surface.mesh());
  runWithoutIntersections(surface,
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
      liftAndPush(s, ManyVertices, true);
    });
  expectSound(surface, kind);
  EXPECT_TRUE(selfIntersections(surface.mesh()).empty());
}

TEST(UndoIntersections, TakesBackWhatIntersects)
{
  SurfaceMesh mesh = slab().mesh();
  const std::vector<Vec3> before = mesh.points;
  EditableSurface moved = slab();
  liftAndPush(moved, OneVertex, false);
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
  liftAndPush(pushed, OneVertex, false);
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
