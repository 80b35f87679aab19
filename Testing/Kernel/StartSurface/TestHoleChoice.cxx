// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/Angles.h"
#include "Shapes/HoleyShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Tubes.h"
#include "StartSurface/HoleChoice.h"

#include <gtest/gtest.h>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

std::size_t numberFilled(const SurfaceMesh& mesh, double gapSize)
{
  return holesToFill(mesh, boundaryLoops(mesh), gapSize).size();
}

/// The corners of a cube, as directions.
std::vector<Vec3> cornerDirections()
{
  std::vector<Vec3> corners;
  for (unsigned b = 0; b < 8; ++b)
  {
    corners.emplace_back(b & 1U ? 1.0 : -1.0, b & 2U ? 1.0 : -1.0, b & 4U ? 1.0 : -1.0);
  }
  return corners;
}

} // namespace

TEST(HoleChoice, TakesSmallHolesThatTheSurfaceGoesOnAcross)
{
  // A cap of the sphere within an angle a of its pole has the fraction (1 - cos a) / 2 of its area.
  EXPECT_EQ(numberFilled(drilledSphere({ Vec3::UnitX() }, 0.2), 0.0), 1U);
  EXPECT_EQ(numberFilled(drilledSphere({ Vec3::UnitX(), Vec3::UnitZ() }, 0.24), 0.0), 2U);
}

TEST(HoleChoice, LeavesOpeningsOfTheShape)
{
  EXPECT_EQ(numberFilled(drilledSphere({ Vec3::UnitX() }, 0.4), 0.0), 0U);
  EXPECT_EQ(numberFilled(drilledSphere({ Vec3::UnitX() }, 0.5 * Pi), 0.0), 0U);
  EXPECT_EQ(numberFilled(openCylinder(24, 10, 0.5, 1.0), 0.0), 0U);
  EXPECT_EQ(numberFilled(sheetWithHole(20, 0.0), 0.0), 0U);
}

TEST(HoleChoice, LeavesTheEndsOfAPipeHoweverThin)
{
  const SurfaceMesh pipe = openCylinder(12, 400, 0.01, 1.0);
  ASSERT_LT(boundaryLoops(pipe).front().vectorArea.norm() / surfaceArea(pipe), 0.006);
  EXPECT_EQ(numberFilled(pipe, 0.0), 0U);
  EXPECT_EQ(numberFilled(pipe, 0.021), 2U);
  EXPECT_EQ(numberFilled(pipe, 0.019), 0U);
}

TEST(HoleChoice, LeavesSmallHolesInAnOpenSheet)
{
  const SurfaceMesh sheet = sheetWithHole(20, 0.1);
  EXPECT_EQ(numberFilled(sheet, 0.0), 0U);
  EXPECT_EQ(numberFilled(sheet, 0.15), 1U); // the hole's diagonal is 0.141
  EXPECT_EQ(numberFilled(sheet, 0.14), 0U);
  // Its own outline is no hole: the cap would be the sheet again.
  EXPECT_EQ(numberFilled(sheet, 10.0), 1U);
}

TEST(HoleChoice, LeavesASievesManyHoles)
{
  // Each a little more than 1 % of the area; eight of them are a pattern.
  std::vector<Vec3> corners = cornerDirections();
  EXPECT_EQ(numberFilled(drilledSphere(corners, 0.22), 0.0), 0U);
  corners.resize(4);
  EXPECT_EQ(numberFilled(drilledSphere(corners, 0.22), 0.0), 4U);
}

TEST(HoleChoice, JudgesEveryComponentByItself)
{
  const SurfaceMesh scan = drilledSphere({ Vec3::UnitX() }, 0.2);
  const SurfaceMesh sheet = transformed(sheetWithHole(20, 0.1), 10.0, Vec3(0.0, 0.0, 3.0));
  const SurfaceMesh scene = merged(scan, sheet);
  const std::vector<BoundaryLoop> holes = holesToFill(scene, boundaryLoops(scene), 0.0);
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_LT(holes[0].vertices.front(), scan.vertexCount());
}
