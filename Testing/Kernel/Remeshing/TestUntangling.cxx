// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/Untangling.h"

#include "Mesh/SelfIntersections.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/Polyhedra.h"

#include <gtest/gtest.h>

namespace
{

using namespace evolving;
using namespace evolving::editing;

/// A slab of thickness 0.1 with vertices of its top, near a point, pushed through the bottom.
EditableSurface pierced(double reach)
{
  EditableSurface slab = shapes::sized(shapes::triangleBox(16, Vec3(1.0, 1.0, 0.05)), 0.125);
  for (const Index v : verticesOf(slab))
  {
    if ((slab.point(v) - Vec3(0.5, 0.5, 0.05)).norm() < reach)
    {
      slab.setPoint(v, slab.point(v) - Vec3(0.0, 0.0, 0.2));
    }
  }
  return slab;
}

TEST(Untangling, SmoothsWhatIntersects)
{
  EditableSurface surface = pierced(0.01);
  const EditableSurface before = surface;
  const auto pairs = selfIntersections(surface.mesh());
  ASSERT_FALSE(pairs.empty());
  EXPECT_TRUE(untangle(surface, pairs));
  EXPECT_TRUE(selfIntersections(surface.mesh()).empty());
  Index moved = 0;
  for (const Index v : verticesOf(surface))
  {
    moved += surface.point(v) != before.point(v) ? 1 : 0;
  }
  EXPECT_GE(moved, 1);
  EXPECT_LE(moved, 2 * 9); // the pushed vertex, and the rings around it and below it
}

TEST(Untangling, LeavesPinnedVerticesAlone)
{
  EditableSurface surface = pierced(0.01);
  for (const Index v : verticesOf(surface))
  {
    surface.setPinned(v);
  }
  const SurfaceMesh before = surface.mesh();
  EXPECT_FALSE(untangle(surface, selfIntersections(before)));
  EXPECT_TRUE(surface.mesh() == before);
}

TEST(Untangling, DoesNotTryWhereManyIntersect)
{
  EditableSurface surface = pierced(0.4);
  const SurfaceMesh before = surface.mesh();
  EXPECT_FALSE(untangle(surface, selfIntersections(before)));
  EXPECT_TRUE(surface.mesh() == before);
}

TEST(Untangling, IsDoneWhereNothingIntersects)
{
  EditableSurface surface = pierced(0.0);
  const SurfaceMesh before = surface.mesh();
  EXPECT_TRUE(untangle(surface, {}));
  EXPECT_TRUE(surface.mesh() == before);
}

} // namespace
