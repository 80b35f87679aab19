// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/VanishedComponents.h"

#include "Shapes/MeshVariants.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

using namespace evolving;

TEST(VanishedComponents, ThereIsNoSmallestOfNone)
{
  SurfaceMesh points;
  points.addPoint(Vec3::Zero());
  for (const SurfaceMesh& mesh : { SurfaceMesh(), points })
  {
    const MeshTopology topology(mesh);
    VanishedComponents none(mesh, topology);
    EXPECT_EQ(none.smallestStartArea(), 0.0);
    none.update(mesh);
  }
}

TEST(VanishedComponents, OneOfTwoThatHasShrunkIsKnown)
{
  const SurfaceMesh start =
    shapes::merged(icosphere(1), shapes::transformed(icosphere(1), 0.5, Vec3(3.0, 0.0, 0.0)));
  const MeshTopology topology(start);
  VanishedComponents vanished(start, topology);
  EXPECT_NEAR(vanished.smallestStartArea(), 0.25 * surfaceArea(icosphere(1)), 1e-12);
  SurfaceMesh shrunk = start;
  for (Vec3& p : shrunk.points)
  {
    p = p.x() > 2.0 ? Vec3(Vec3(3.0, 0.0, 0.0) + 1e-5 * (p - Vec3(3.0, 0.0, 0.0))) : p;
  }
  vanished.update(shrunk);
  EXPECT_FALSE(vanished.contain(0));
  EXPECT_TRUE(vanished.contain(start.vertexCount() - 1));
}
