// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/SharpEdges.h"
#include "Shapes/CreasedShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <random>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

std::size_t sharpCount(const SurfaceMesh& mesh, double angle, bool withBoundary = false)
{
  const TargetTriangles target(mesh);
  return SharpEdges(target, angle, withBoundary).list().size();
}

} // namespace

TEST(SharpEdges, OfABoxAreItsTwelve)
{
  const TargetTriangles target(box(Vec3(0, 0, 0), Vec3(1, 2, 3)));
  const SharpEdges sharp(target, 45.0, false);
  ASSERT_EQ(sharp.list().size(), 12u);
  for (const Index edge : sharp.list())
  {
    EXPECT_NEAR(sharp.fold(edge), 90.0, 1e-10);
  }
}

TEST(SharpEdges, DoNotDependOnHowFacesAreTurned)
{
  const SurfaceMesh mesh = extruded(regularPolygon(7), 1.0);
  const SurfaceMesh mixed = turned(mesh, [](Index face) { return face % 3 == 1; });
  const TargetTriangles target(mesh);
  const TargetTriangles targetMixed(mixed);
  EXPECT_EQ(SharpEdges(target, 45.0, false).list(), SharpEdges(targetMixed, 45.0, false).list());
  EXPECT_EQ(SharpEdges(target, 45.0, false).list().size(), 21u);
}

TEST(SharpEdges, HaveFoldsLargerThanTheAngle)
{
  // An octagonal prism: 45 degrees along, 90 around the caps.
  const SurfaceMesh mesh = extruded(regularPolygon(8), 1.0);
  EXPECT_EQ(sharpCount(mesh, 44.0), 24u);
  EXPECT_EQ(sharpCount(mesh, 46.0), 16u);
  EXPECT_EQ(sharpCount(mesh, 91.0), 0u);
}

TEST(SharpEdges, AreNotDecidedByRounding)
{
  std::mt19937 generator(1);
  for (int trial = 0; trial < 20; ++trial)
  {
    SurfaceMesh mesh = mapped(extruded(regularPolygon(8), 1.0), randomRotation(generator));
    for (Vec3& point : mesh.points)
    {
      point = point.cast<float>().cast<double>();
    }
    EXPECT_EQ(sharpCount(mesh, 45.0), 16u);
  }
}

TEST(SharpEdges, IncludeThoseOfThreeFaces)
{
  SurfaceMesh mesh;
  mesh.points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, -1, 0.1) };
  mesh.addFace({ 0, 1, 2 });
  mesh.addFace({ 1, 0, 3 });
  EXPECT_EQ(sharpCount(mesh, 100.0), 0u);
  mesh.addFace({ 1, 0, 4 });
  EXPECT_EQ(sharpCount(mesh, 180.0), 1u);
}

TEST(SharpEdges, IncludeTheBoundaryWhenWanted)
{
  const SurfaceMesh sheet = heightField(5, [](double, double) { return 0.0; });
  EXPECT_EQ(sharpCount(sheet, 45.0), 0u);
  EXPECT_EQ(sharpCount(sheet, 45.0, true), 20u);
}

TEST(SharpEdges, CountTrianglesGivenTwiceOnce)
{
  const SurfaceMesh cube = box(Vec3(0, 0, 0), Vec3(1, 1, 1));
  EXPECT_EQ(sharpCount(merged(cube, reversed(cube)), 45.0), 12u);
}

TEST(SharpEdges, LeadThroughSliversOnce)
{
  // Two faces at right angles with a crease from 0 to 1; point 4 lies on it, as far off as floats
  // put it, and belongs to one of them only.
  SurfaceMesh mesh;
  mesh.points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 1, 0), Vec3(0.5, 0, 1),
    Vec3(0.5, -3e-8, 5e-8) };
  mesh.addFace({ 0, 1, 2 });
  mesh.addFace({ 1, 0, 4 });
  mesh.addFace({ 0, 3, 4 });
  mesh.addFace({ 4, 3, 1 });
  const TargetTriangles target(mesh);
  const SharpEdges sharp(target, 45.0, false);
  ASSERT_EQ(sharp.list().size(), 2u);
  for (const Index edge : sharp.list())
  {
    EXPECT_EQ(target.edgeVertices(edge)[1], 4);
    EXPECT_NEAR(sharp.fold(edge), 90.0, 1e-4);
  }
}

TEST(SharpEdges, OfASmoothSphereAreNone)
{
  EXPECT_EQ(sharpCount(sphere(4), 15.0), 0u);
}
