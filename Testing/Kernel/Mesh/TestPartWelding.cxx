// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/PartWelding.h"

#include "Mesh/SurfaceMesh.h"
#include "Mesh/TopologySummary.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

namespace evolving
{

using namespace evolving::shapes;

namespace
{

/// Two cubes that have an edge in common, each with points of its own.
SurfaceMesh touchingCubes()
{
  SurfaceMesh second = unitCube();
  const Vec3 sizes = boundingBox(second).sizes();
  for (Vec3& point : second.points)
  {
    point += Vec3(sizes.x(), sizes.y(), 0.0);
  }
  return merged(unitCube(), second);
}

/// A sphere without some faces beside its first one, which are added with points of their own.
SurfaceMesh withSeam(const SurfaceMesh& sphere)
{
  SurfaceMesh mesh;
  mesh.points = sphere.points;
  for (Index face = 0; face < sphere.faceCount(); ++face)
  {
    std::vector<Index> vertices;
    for (Index k = 0; k < 3; ++k)
    {
      const Index vertex = sphere.faceVertex(face, k);
      vertices.push_back(face < 7 ? mesh.addPoint(sphere.points[at(vertex)]) : vertex);
    }
    mesh.addFace(vertices);
  }
  return mesh;
}

} // namespace

TEST(PartWelding, LeavesClosedPartsAsTheyAre)
{
  const SurfaceMesh cubes = touchingCubes();
  EXPECT_GT(summarizeTopology(weldCoincidentPoints(cubes)).nonManifoldEdges, 0);
  EXPECT_TRUE(weldOpenParts(cubes) == cubes);
}

TEST(PartWelding, GivesASoupItsTopologyBack)
{
  const SurfaceMesh sphere = unitIcosphere(2);
  EXPECT_EQ(weldOpenParts(soupOf(sphere)).vertexCount(), sphere.vertexCount());
  EXPECT_TRUE(summarizeTopology(weldOpenParts(soupOf(sphere))).isClosed());
}

TEST(PartWelding, ClosesSeams)
{
  const SurfaceMesh sphere = unitIcosphere(2);
  const SurfaceMesh welded = weldOpenParts(withSeam(sphere));
  EXPECT_EQ(welded.vertexCount(), sphere.vertexCount());
  EXPECT_TRUE(summarizeTopology(welded).isClosed());
}

TEST(PartWelding, KeepsAClosedPartApartFromAnOpenOne)
{
  // The soup of a cube beside a cube that is closed.
  const SurfaceMesh cubes = touchingCubes();
  SurfaceMesh first = unitCube();
  SurfaceMesh second = unitCube();
  second.points.assign(cubes.points.begin() + first.vertexCount(), cubes.points.end());
  const SurfaceMesh welded = weldOpenParts(merged(first, soupOf(second)));
  EXPECT_EQ(welded.vertexCount(), cubes.vertexCount());
  EXPECT_TRUE(summarizeTopology(welded).isClosed());
}

TEST(PartWelding, TakesEdgesWithoutLengthOutOfClosedParts)
{
  SurfaceMesh sphere = unitIcosphere(2);
  sphere.points[at(sphere.faceVertex(0, 1))] = sphere.points[at(sphere.faceVertex(0, 0))];
  const SurfaceMesh welded = weldOpenParts(sphere);
  EXPECT_EQ(welded.vertexCount(), sphere.vertexCount() - 1);
  EXPECT_EQ(welded.faceCount(), sphere.faceCount() - 2);
  EXPECT_TRUE(summarizeTopology(welded).isClosed());
}

TEST(PartWelding, PartsThatDisagreeInOrientationAreNoClosedParts)
{
  SurfaceMesh cubes = touchingCubes();
  std::swap(cubes.cornerVertices[0], cubes.cornerVertices[1]);
  EXPECT_EQ(weldOpenParts(cubes).vertexCount(), cubes.vertexCount());
  SurfaceMesh twice = merged(unitIcosphere(1), unitIcosphere(1));
  std::swap(twice.cornerVertices[0], twice.cornerVertices[1]);
  std::swap(twice.cornerVertices[at(twice.cornerCount() - 1)],
    twice.cornerVertices[at(twice.cornerCount() - 2)]);
  EXPECT_EQ(weldOpenParts(twice).vertexCount(), unitIcosphere(1).vertexCount());
}

TEST(PartWelding, UnusedPointsStayOut)
{
  SurfaceMesh sphere = unitIcosphere(1);
  sphere.addPoint(sphere.points[0]);
  EXPECT_EQ(verticesToJoin(sphere).back(), NoIndex);
  EXPECT_EQ(weldOpenParts(sphere).vertexCount(), unitIcosphere(1).vertexCount());
}

} // namespace evolving
