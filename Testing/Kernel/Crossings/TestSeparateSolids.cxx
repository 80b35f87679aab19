// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/SeparateSolids.h"

#include "Mesh/SurfaceParts.h"
#include "Mesh/TopologySummary.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"

#include <gtest/gtest.h>

#include <random>

using namespace evolving;

namespace
{

SurfaceMesh cube(const Vec3& low)
{
  return shapes::box(low, low + Vec3::Ones());
}

/// Expects so many closed manifolds.
void expectSolids(const SurfaceMesh& apart, std::size_t count)
{
  const TopologySummary topology = summarizeTopology(apart);
  EXPECT_TRUE(topology.isClosed() && topology.isManifold());
  EXPECT_EQ(surfaceParts(apart).list.size(), count);
}

} // namespace

TEST(SeparateSolids, OfAManifoldIsItself)
{
  const SurfaceMesh mesh = cube(Vec3::Zero());
  const SurfaceMesh apart = separateSolids(mesh);
  EXPECT_EQ(apart.faceCount(), mesh.faceCount());
  EXPECT_EQ(apart.vertexCount(), mesh.vertexCount());
  expectSolids(apart, 1);
}

TEST(SeparateSolids, KeepsTrianglesAndTheirOrder)
{
  const SurfaceMesh mesh =
    weldCoincidentPoints(shapes::merged(cube(Vec3::Zero()), cube({ 1, 1, 0 })));
  const SurfaceMesh apart = separateSolids(mesh);
  ASSERT_EQ(apart.faceCount(), mesh.faceCount());
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    for (Index k = 0; k < 3; ++k)
    {
      EXPECT_EQ(apart.facePoint(face, k), mesh.facePoint(face, k));
    }
  }
}

TEST(SeparateSolids, TakesSolidsApartThatShareACornerAnEdgeOrAFace)
{
  std::mt19937 generator(5);
  for (const Vec3& step : { Vec3(1, 1, 1), Vec3(1, 1, 0), Vec3(1, 0, 0) })
  {
    const SurfaceMesh two = shapes::merged(cube(Vec3::Zero()), cube(step));
    const SurfaceMesh mesh = weldCoincidentPoints(shapes::shuffled(two, generator));
    EXPECT_LT(mesh.vertexCount(), 16);
    expectSolids(separateSolids(mesh), 2);
  }
}

TEST(SeparateSolids, TakesFourSolidsAroundAnEdgeApart)
{
  SurfaceMesh four;
  for (const Vec3& low : { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0) })
  {
    four = shapes::merged(four, cube(low));
  }
  expectSolids(separateSolids(weldCoincidentPoints(four)), 4);
}

TEST(SeparateSolids, LeavesEdgesWithASheetTogether)
{
  // A sheet that stands on an edge of a cube: three faces.
  SurfaceMesh mesh = cube(Vec3::Zero());
  const Index top = mesh.addPoint({ 0, 0, 2 });
  const Index above = mesh.addPoint({ 0, 1, 2 });
  Index a = NoIndex;
  Index b = NoIndex;
  for (Index v = 0; v < 8; ++v)
  {
    a = mesh.points[at(v)] == Vec3(0, 0, 1) ? v : a;
    b = mesh.points[at(v)] == Vec3(0, 1, 1) ? v : b;
  }
  mesh.addFace({ a, b, top });
  mesh.addFace({ b, above, top });
  const SurfaceMesh apart = separateSolids(mesh);
  EXPECT_EQ(summarizeTopology(apart).nonManifoldEdges, 1);
  EXPECT_EQ(surfaceParts(apart).list.size(), 1U);
}
