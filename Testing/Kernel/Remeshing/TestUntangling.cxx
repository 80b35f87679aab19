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

/// A slab of thickness 0.1.
EditableSurface slab()
{
  return shapes::sized(shapes::triangleBox(16, Vec3(1.0, 1.0, 0.05)), 0.125);
}

/// Pushes vertices of the slab's top, near a point, through the bottom.
void pierce(EditableSurface& slab, const Vec3& place, double reach)
{
  for (const Index v : verticesOf(slab))
  {
    if ((slab.point(v) - place).norm() < reach)
    {
      slab.setPoint(v, slab.point(v) - Vec3(0.0, 0.0, 0.2));
    }
  }
}

EditableSurface pierced(double reach)
{
  EditableSurface surface = slab();
  pierce(surface, Vec3(0.5, 0.5, 0.05), reach);
  return surface;
}

TEST(Untangling, SmoothsWhatIntersects)
{
  EditableSurface surface = pierced(0.01);
  const EditableSurface before = surface;
  const auto pairs = selfIntersections(surface.mesh());
  ASSERT_FALSE(pairs.empty());
  EXPECT_TRUE(untangle(surface, pairs).empty());
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
  EXPECT_EQ(untangle(surface, selfIntersections(before)), selfIntersections(before));
  EXPECT_TRUE(surface.mesh() == before);
}

TEST(Untangling, DoesNotTryWhereManyIntersect)
{
  EditableSurface surface = pierced(0.4);
  const SurfaceMesh before = surface.mesh();
  EXPECT_EQ(untangle(surface, selfIntersections(before)), selfIntersections(before));
  EXPECT_TRUE(surface.mesh() == before);
}

TEST(Untangling, JudgesPlaceByPlace)
{
  EditableSurface surface = slab();
  pierce(surface, Vec3(-0.5, -0.5, 0.05), 0.4);
  const auto many = selfIntersections(surface.mesh());
  for (const double x : { -0.25, 0.25, 0.75 })
  {
    pierce(surface, Vec3(x, 0.75, 0.05), 0.01);
  }
  ASSERT_GT(selfIntersections(surface.mesh()).size(), many.size());
  EXPECT_EQ(untangle(surface, selfIntersections(surface.mesh())).size(), many.size());
  EXPECT_EQ(selfIntersections(surface.mesh()).size(), many.size());
}

TEST(Untangling, IsDoneWhereNothingIntersects)
{
  EditableSurface surface = pierced(0.0);
  const SurfaceMesh before = surface.mesh();
  EXPECT_TRUE(untangle(surface, {}).empty());
  EXPECT_TRUE(surface.mesh() == before);
}

} // namespace
