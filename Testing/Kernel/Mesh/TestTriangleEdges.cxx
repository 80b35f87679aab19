// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/TriangleEdges.h"

#include "Shapes/MeshVariants.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

using namespace evolving;
using namespace evolving::shapes;

TEST(TriangleEdges, OfAClosedMeshHaveTwoFacesInOppositeDirections)
{
  const SurfaceMesh mesh = sphere(3);
  const TriangleEdges edges(mesh);
  EXPECT_EQ(mesh.vertexCount() - edges.edgeCount() + mesh.faceCount(), 2);
  for (Index edge = 0; edge < edges.edgeCount(); ++edge)
  {
    ASSERT_EQ(edges.faceCount(edge), 2);
    const Index* corners = edges.begin(edge);
    EXPECT_LT(corners[0], corners[1]);
    EXPECT_NE(
      TriangleEdges::runsUpwards(mesh, corners[0]), TriangleEdges::runsUpwards(mesh, corners[1]));
    EXPECT_EQ(edges.edgeOf(corners[0]), edge);
    EXPECT_EQ(edges.edgeOf(corners[1]), edge);
  }
}

TEST(TriangleEdges, CountAnyNumberOfFacesAtAnEdge)
{
  SurfaceMesh mesh;
  mesh.points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1) };
  mesh.addFace({ 0, 1, 2 });
  mesh.addFace({ 1, 0, 3 });
  mesh.addFace({ 0, 1, 4 });
  const TriangleEdges edges(mesh);
  EXPECT_EQ(edges.edgeCount(), 7);
  EXPECT_EQ(edges.faceCount(edges.edgeOf(0)), 3);
  EXPECT_EQ(edges.faceCount(edges.edgeOf(1)), 1);
}

TEST(TriangleEdges, OfNothingAreNone)
{
  EXPECT_EQ(TriangleEdges(SurfaceMesh()).edgeCount(), 0);
}

TEST(TriangleEdges, OfAMeshWithTurnedFacesAreThoseOfThatMesh)
{
  const SurfaceMesh whole = randomSoup(50, 0.5, 3);
  for (const SurfaceMesh& mesh : { sphere(3), bowl(3, 0.2), whole })
  {
    std::vector<char> isTurned;
    SurfaceMesh turnedMesh = mesh;
    for (Index face = 0; face < mesh.faceCount(); ++face)
    {
      isTurned.push_back(face % 3 == 0 || face % 7 == 2);
      if (isTurned.back())
      {
        std::swap(
          turnedMesh.cornerVertices[at(3 * face + 1)], turnedMesh.cornerVertices[at(3 * face + 2)]);
      }
    }
    TriangleEdges edges(mesh);
    edges.turn(isTurned);
    const TriangleEdges expected(turnedMesh);
    ASSERT_EQ(edges.edgeCount(), expected.edgeCount());
    for (Index edge = 0; edge < edges.edgeCount(); ++edge)
    {
      EXPECT_EQ(std::vector<Index>(edges.begin(edge), edges.end(edge)),
        std::vector<Index>(expected.begin(edge), expected.end(edge)));
    }
    for (Index corner = 0; corner < mesh.cornerCount(); ++corner)
    {
      EXPECT_EQ(edges.edgeOf(corner), expected.edgeOf(corner));
    }
  }
}
