// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/SurfaceParts.h"

#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"

#include <gtest/gtest.h>

using namespace evolving;

TEST(SurfaceParts, AreNumberedByTheirFirstFaces)
{
  const SurfaceMesh mesh = shapes::merged(shapes::box(Vec3::Zero(), Vec3(1, 2, 3)),
    shapes::triangleMesh({ 9, 0, 0 }, { 9, 1, 0 }, { 9, 0, 1 }));
  const SurfaceParts parts = surfaceParts(mesh);
  ASSERT_EQ(parts.list.size(), 2U);
  EXPECT_EQ(parts.ofFace.front(), 0);
  EXPECT_EQ(parts.ofFace.back(), 1);
  EXPECT_TRUE(parts.list[0].isClosed);
  EXPECT_FALSE(parts.list[1].isClosed);
  EXPECT_DOUBLE_EQ(parts.list[0].area, 22.0);
  EXPECT_DOUBLE_EQ(parts.list[0].sixVolumes, 36.0);
  EXPECT_DOUBLE_EQ(parts.list[0].meanThickness(), 12.0 / 22.0);
  EXPECT_DOUBLE_EQ(parts.list[1].area, 0.5);
}

TEST(SurfaceParts, AreConnectedByEdgesAlone)
{
  const SurfaceMesh touching = weldCoincidentPoints(shapes::merged(
    shapes::box(Vec3::Zero(), Vec3::Ones()), shapes::box(Vec3::Ones(), Vec3(2, 2, 2))));
  EXPECT_EQ(surfaceParts(touching).list.size(), 2U);
  EXPECT_TRUE(surfaceParts(touching).list[0].isClosed);
}

TEST(SurfaceParts, WithAnEdgeOfFourFacesAreNotClosed)
{
  const SurfaceMesh touching = weldCoincidentPoints(
    shapes::merged(shapes::box(Vec3::Zero(), Vec3::Ones()), shapes::box({ 1, 1, 0 }, { 2, 2, 1 })));
  const SurfaceParts parts = surfaceParts(touching);
  ASSERT_EQ(parts.list.size(), 1U);
  EXPECT_FALSE(parts.list[0].isClosed);
}
