// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/TopologySummary.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"

#include <gtest/gtest.h>

#include <random>

namespace evolving
{

using namespace evolving::shapes;

namespace
{

TEST(TopologySummary, EmptyMeshCountsNothing)
{
  const TopologySummary summary = summarizeTopology(SurfaceMesh());
  EXPECT_EQ(summary.usedVertices, 0);
  EXPECT_EQ(summary.edges, 0);
  EXPECT_EQ(summary.faces, 0);
  EXPECT_EQ(summary.components, 0);
  EXPECT_EQ(summary.eulerCharacteristic(), 0);
  EXPECT_EQ(summary.genus(), 0);
}

TEST(TopologySummary, ClosedSurfacesHaveTheirGenus)
{
  const struct
  {
    SurfaceMesh mesh;
    Index genus;
  } cases[] = { { cornerTetrahedron(), 0 }, { unitCube(), 0 }, { unitIcosphere(2), 0 },
    { quadTorus(7, 5, 2.0, 0.5), 1 }, { slabWithHoles(1), 1 }, { slabWithHoles(2), 2 },
    { slabWithHoles(5), 5 } };
  for (const auto& c : cases)
  {
    std::mt19937 generator(1);
    for (const SurfaceMesh& mesh : { c.mesh, triangulated(c.mesh, generator) })
    {
      const TopologySummary summary = summarizeTopology(mesh);
      EXPECT_TRUE(summary.isClosed());
      EXPECT_TRUE(summary.isManifold());
      EXPECT_TRUE(summary.isOriented());
      EXPECT_EQ(summary.components, 1);
      EXPECT_EQ(summary.genus(), c.genus);
      EXPECT_EQ(summary.eulerCharacteristic(), 2 - 2 * c.genus);
    }
  }
}

TEST(TopologySummary, GenusAddsOverComponents)
{
  const SurfaceMesh both = merged(merged(slabWithHoles(2), unitCube()), quadTorus(5, 4, 2, 1));
  const TopologySummary summary = summarizeTopology(both);
  EXPECT_EQ(summary.components, 3);
  EXPECT_EQ(summary.genus(), 3);
}

TEST(TopologySummary, CountsBoundaryEdges)
{
  EXPECT_EQ(summarizeTopology(annulus(8)).boundaryEdges, 16);
  EXPECT_EQ(summarizeTopology(annulus(8)).eulerCharacteristic(), 0);
  EXPECT_EQ(summarizeTopology(fan(6)).boundaryEdges, 6);
  EXPECT_EQ(summarizeTopology(fan(6)).eulerCharacteristic(), 1);
  EXPECT_FALSE(summarizeTopology(fan(6)).isClosed());
  EXPECT_TRUE(summarizeTopology(fan(6)).isManifold());
}

TEST(TopologySummary, MoebiusBandIsManifoldButCannotBeOriented)
{
  const TopologySummary summary = summarizeTopology(moebiusBand(9));
  EXPECT_EQ(summary.boundaryEdges, 18);
  EXPECT_EQ(summary.eulerCharacteristic(), 0);
  EXPECT_TRUE(summary.isManifold());
  EXPECT_EQ(summary.flippedEdges, 1);
}

TEST(TopologySummary, CountsEdgesOfThreeFaces)
{
  const SurfaceMesh fins =
    makeMesh({ { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, -1, 0 } },
      { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } });
  const TopologySummary summary = summarizeTopology(fins);
  EXPECT_EQ(summary.nonManifoldEdges, 1);
  EXPECT_EQ(summary.nonManifoldVertices, 0) << "one fan, held together by the edge";
  EXPECT_EQ(summary.boundaryEdges, 6);
  EXPECT_FALSE(summary.isManifold());
  EXPECT_FALSE(summary.isClosed());
}

TEST(TopologySummary, TwoCubesAtAnEdgeAreClosedButNotManifold)
{
  const TopologySummary summary = summarizeTopology(cellSurface({ { 0, 0, 0 }, { 1, 1, 0 } }));
  EXPECT_EQ(summary.nonManifoldEdges, 1);
  EXPECT_EQ(summary.boundaryEdges, 0);
  EXPECT_FALSE(summary.isClosed());
}

TEST(TopologySummary, TwoCubesAtAVertexAreOneComponentWithOneBadVertex)
{
  const TopologySummary summary = summarizeTopology(cellSurface({ { 0, 0, 0 }, { 1, 1, 1 } }));
  EXPECT_EQ(summary.components, 1);
  EXPECT_EQ(summary.nonManifoldEdges, 0);
  EXPECT_EQ(summary.nonManifoldVertices, 1);
  EXPECT_TRUE(summary.isClosed());
  EXPECT_FALSE(summary.isManifold());
}

TEST(TopologySummary, BowTieOfOpenFansIsOneBadVertex)
{
  const SurfaceMesh bowTie =
    makeMesh({ { 0, 0, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 }, { -1, -1, 0 } },
      { { 0, 1, 2 }, { 0, 3, 4 } });
  const TopologySummary summary = summarizeTopology(bowTie);
  EXPECT_EQ(summary.nonManifoldVertices, 1);
  EXPECT_EQ(summary.components, 1);
}

TEST(TopologySummary, CountsFlippedFaces)
{
  SurfaceMesh mesh = cornerTetrahedron();
  std::swap(mesh.cornerVertices[0], mesh.cornerVertices[1]);
  EXPECT_EQ(summarizeTopology(mesh).flippedEdges, 3);
  EXPECT_FALSE(summarizeTopology(mesh).isOriented());
}

TEST(TopologySummary, UnusedVerticesDoNotCount)
{
  SurfaceMesh mesh;
  mesh.addPoint({ 9, 9, 9 });
  mesh = merged(mesh, merged(unitCube(), makeMesh({ { 5, 5, 5 } }, {})));
  const TopologySummary summary = summarizeTopology(mesh);
  EXPECT_EQ(summary.usedVertices, 8);
  EXPECT_EQ(summary.components, 1);
  EXPECT_EQ(summary.eulerCharacteristic(), 2);
}

TEST(TopologySummary, DuplicateFacesMakeEdgesOfFourFaces)
{
  SurfaceMesh mesh = cornerTetrahedron();
  mesh.addFace({ 1, 2, 3 });
  mesh.addFace({ 3, 2, 1 });
  EXPECT_EQ(summarizeTopology(mesh).nonManifoldEdges, 3);
}

} // namespace

} // namespace evolving
