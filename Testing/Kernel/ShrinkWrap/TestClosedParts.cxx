// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/ClosedParts.h"

#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "ShrinkWrap/WrapRuns.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

using namespace evolving;

namespace
{

std::vector<char> all(const SurfaceMesh& mesh, char flag)
{
  return std::vector<char>(at(mesh.faceCount()), flag);
}

/// A wedge with an edge of a few degrees, whose sides are nearer to each other there than a wall.
SurfaceMesh knife()
{
  SurfaceMesh mesh;
  mesh.points = { { 0, 0, 0 }, { 10, 0, 0 }, { 10, 1.4, 0 }, { 0, 0, 4 }, { 10, 0, 4 },
    { 10, 1.4, 4 } };
  for (const auto& [a, b, c] : std::vector<std::array<Index, 3>>{ { 0, 2, 1 }, { 3, 4, 5 },
         { 0, 1, 4 }, { 0, 4, 3 }, { 1, 2, 5 }, { 1, 5, 4 }, { 2, 0, 3 }, { 2, 3, 5 } })
  {
    mesh.addFace({ a, b, c });
  }
  return mesh;
}

} // namespace

TEST(ClosedParts, OfClosedSurfacesAreAllFacesHoweverTheyAreTurned)
{
  const SurfaceMesh sphere = icosphere(2);
  EXPECT_EQ(facesOfClosedParts(sphere, 0.1), all(sphere, 1));
  EXPECT_EQ(facesOfClosedParts(reversed(sphere), 0.1), all(sphere, 1));
}

TEST(ClosedParts, OfAnOpenSurfaceAreNone)
{
  const SurfaceMesh cap = shapes::without(icosphere(2), [](Index face) { return face == 0; });
  EXPECT_EQ(facesOfClosedParts(cap, 0.0), all(cap, 0));
}

TEST(ClosedParts, AreToldFromOpenOnesBesideThem)
{
  const SurfaceMesh sphere = icosphere(1);
  const SurfaceMesh sheet = shapes::sheet(3, true);
  std::vector<char> expected = all(sphere, 1);
  expected.resize(expected.size() + at(sheet.faceCount()), 0);
  EXPECT_EQ(facesOfClosedParts(shapes::merged(sphere, sheet), 0.1), expected);
}

TEST(ClosedParts, ASheetWithTwoSidesOnTheSamePointsIsNone)
{
  const SurfaceMesh twice =
    weldCoincidentPoints(shapes::merged(shapes::sheet(3, true), reversed(shapes::sheet(3, true))));
  EXPECT_EQ(facesOfClosedParts(twice, 0.0), all(twice, 0));
}

TEST(ClosedParts, FacesThatUseAPointTwiceHaveNoSay)
{
  SurfaceMesh sphere = icosphere(1);
  sphere.addFace({ sphere.faceVertex(0, 0), sphere.faceVertex(0, 1), sphere.faceVertex(0, 1) });
  std::vector<char> expected = all(sphere, 1);
  expected.back() = 0;
  EXPECT_EQ(facesOfClosedParts(sphere, 0.1), expected);
}

TEST(ClosedParts, ThatAreThinAsAPlateAreNone)
{
  for (const Vec3& far : { Vec3(0, 0, 0), Vec3(1e5, -2e5, 3e5) })
  {
    const SurfaceMesh plate =
      shapes::transformed(shapes::triangleBox(4, Vec3(1.0, 1.0, 0.05)), 1.0, far);
    // 2 x 2 x 0.1: twice its volume over its area is 0.8 / 8.8.
    EXPECT_EQ(facesOfClosedParts(plate, 0.090), all(plate, 1));
    EXPECT_EQ(facesOfClosedParts(plate, 0.092), all(plate, 0));
  }
}

TEST(ClosedParts, AreNoSheetsWhereTheirEdgesAreAcute)
{
  ShrinkWrapOptions options = wraps::quick(0.4, 48);
  const auto reference = prepareShrinkWrap(knife(), options).reference;
  EXPECT_FALSE(reference->hasSheets());
  EXPECT_TRUE(reference->isOnTarget());
}
