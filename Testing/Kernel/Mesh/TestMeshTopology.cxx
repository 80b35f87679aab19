// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/MeshTopology.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace evolving
{

using namespace evolving::shapes;

namespace
{

struct NamedMesh
{
  std::string name;
  SurfaceMesh mesh;
};

std::vector<NamedMesh> manifoldMeshes()
{
  std::mt19937 generator(42);
  std::vector<NamedMesh> meshes{ { "Empty", {} }, { "Tetrahedron", cornerTetrahedron() },
    { "Cube", unitCube() }, { "Icosphere", unitIcosphere(2) },
    { "Torus", quadTorus(7, 5, 2.0, 0.5) }, { "Genus2", triangulated(slabWithHoles(2), generator) },
    { "Annulus", annulus(6) }, { "Disc", fan(7) }, { "Sheet", triangleSheet(4, 5) },
    { "UnusedPoints", merged(makeMesh({ { 9, 9, 9 } }, {}), fan(4)) },
    { "Triangle", makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } }) },
    { "TwoSided",
      makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 2, 1, 0 } }) },
    { "Several", merged(merged(fan(5), unitCube()), annulus(4)) } };
  const std::size_t count = meshes.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    meshes.push_back({ "Shuffled" + meshes[i].name, shuffled(meshes[i].mesh, generator) });
  }
  return meshes;
}

class ManifoldTopology : public testing::TestWithParam<NamedMesh>
{
protected:
  const SurfaceMesh& Mesh = this->GetParam().mesh;
  MeshTopology Topology{ this->Mesh };
};

INSTANTIATE_TEST_SUITE_P(Meshes, ManifoldTopology, testing::ValuesIn(manifoldMeshes()),
  [](const testing::TestParamInfo<NamedMesh>& test) { return test.param.name; });

TEST_P(ManifoldTopology, NextAndPreviousWalkAroundTheFace)
{
  ASSERT_EQ(this->Topology.cornerCount(), this->Mesh.cornerCount());
  ASSERT_EQ(this->Topology.faceCount(), this->Mesh.faceCount());
  ASSERT_EQ(this->Topology.vertexCount(), this->Mesh.vertexCount());
  for (Index c = 0; c < this->Topology.cornerCount(); ++c)
  {
    EXPECT_EQ(this->Topology.previous(this->Topology.next(c)), c);
    EXPECT_EQ(this->Topology.faceOf(this->Topology.next(c)), this->Topology.faceOf(c));
    Index walked = c;
    for (Index k = 0; k < this->Mesh.faceSize(this->Topology.faceOf(c)); ++k)
    {
      walked = this->Topology.next(walked);
      EXPECT_EQ(walked == c, k + 1 == this->Mesh.faceSize(this->Topology.faceOf(c)));
    }
  }
}

TEST_P(ManifoldTopology, OppositeIsTheSameEdgeBackwards)
{
  const MeshTopology& t = this->Topology;
  for (Index c = 0; c < t.cornerCount(); ++c)
  {
    const Index o = t.opposite(c);
    if (o != NoIndex)
    {
      EXPECT_NE(o, c);
      EXPECT_EQ(t.opposite(o), c);
      EXPECT_EQ(t.vertexOf(o), t.vertexOf(t.next(c)));
      EXPECT_EQ(t.vertexOf(t.next(o)), t.vertexOf(c));
    }
    else
    {
      EXPECT_TRUE(t.isBoundary(t.vertexOf(c)));
      EXPECT_TRUE(t.isBoundary(t.vertexOf(t.next(c))));
    }
  }
}

TEST_P(ManifoldTopology, RingsHoldEveryCornerOfTheirVertexOnce)
{
  std::vector<Index> seen;
  for (Index v = 0; v < this->Topology.vertexCount(); ++v)
  {
    EXPECT_EQ(this->Topology.isUsed(v), this->Topology.ringCorners(v).size() > 0);
    for (const Index c : this->Topology.ringCorners(v))
    {
      EXPECT_EQ(this->Topology.vertexOf(c), v);
      seen.push_back(c);
    }
  }
  std::sort(seen.begin(), seen.end());
  ASSERT_EQ(static_cast<Index>(seen.size()), this->Topology.cornerCount());
  for (Index c = 0; c < this->Topology.cornerCount(); ++c)
  {
    EXPECT_EQ(seen[static_cast<std::size_t>(c)], c);
  }
}

TEST_P(ManifoldTopology, RingsRunCounterClockwise)
{
  const MeshTopology& t = this->Topology;
  for (Index v = 0; v < t.vertexCount(); ++v)
  {
    const MeshTopology::Run corners = t.ringCorners(v);
    const MeshTopology::Run vertices = t.ringVertices(v);
    const bool boundary = t.isBoundary(v);
    ASSERT_EQ(vertices.size(), corners.size() + (boundary ? 1 : 0));
    for (Index i = 0; i < corners.size(); ++i)
    {
      EXPECT_EQ(t.vertexOf(t.next(corners[i])), vertices[i]);
      EXPECT_EQ(t.vertexOf(t.previous(corners[i])), vertices[(i + 1) % vertices.size()]);
      const bool last = i + 1 == corners.size();
      const Index successor = last && boundary ? NoIndex : corners[(i + 1) % corners.size()];
      EXPECT_EQ(t.opposite(t.previous(corners[i])), successor);
    }
    if (boundary)
    {
      EXPECT_EQ(t.opposite(corners[0]), NoIndex) << "begins at its boundary edge";
    }
  }
}

TEST_P(ManifoldTopology, BoundaryLoopsHoldEveryBoundaryEdgeOnce)
{
  const MeshTopology& t = this->Topology;
  std::set<std::pair<Index, Index>> expected;
  for (Index c = 0; c < t.cornerCount(); ++c)
  {
    if (t.opposite(c) == NoIndex)
    {
      expected.emplace(t.vertexOf(c), t.vertexOf(t.next(c)));
    }
  }
  std::set<std::pair<Index, Index>> found;
  for (const std::vector<Index>& loop : t.boundaryLoops())
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      EXPECT_TRUE(found.emplace(loop[i], loop[(i + 1) % loop.size()]).second);
    }
  }
  EXPECT_EQ(found, expected) << "in the direction of the faces: the surface on the left";
}

TEST_P(ManifoldTopology, ComponentsAgreeAlongEdgesAndAreNumberedBySmallestVertex)
{
  const MeshTopology& t = this->Topology;
  const std::vector<Index>& component = t.componentOfVertex();
  Index highest = NoIndex;
  for (Index v = 0; v < t.vertexCount(); ++v)
  {
    const Index own = component[static_cast<std::size_t>(v)];
    EXPECT_EQ(own == NoIndex, !t.isUsed(v));
    EXPECT_LE(own, highest + 1);
    highest = std::max(highest, own);
    for (const Index neighbour : t.ringVertices(v))
    {
      EXPECT_EQ(component[static_cast<std::size_t>(neighbour)], own);
    }
  }
  EXPECT_EQ(t.componentCount(), highest + 1);
}

TEST(MeshTopology, LoopsOfAnnulusAndDisc)
{
  const MeshTopology ring(annulus(6));
  ASSERT_EQ(ring.boundaryLoops().size(), 2U);
  EXPECT_EQ(ring.boundaryLoops()[0], (std::vector<Index>{ 0, 10, 8, 6, 4, 2 })) << "inner";
  EXPECT_EQ(ring.boundaryLoops()[1], (std::vector<Index>{ 1, 3, 5, 7, 9, 11 })) << "outer";
  const MeshTopology plate(fan(5));
  ASSERT_EQ(plate.boundaryLoops().size(), 1U);
  EXPECT_EQ(plate.boundaryLoops()[0], (std::vector<Index>{ 1, 2, 3, 4, 5 }));
  EXPECT_FALSE(plate.isBoundary(0));
  EXPECT_TRUE(MeshTopology(unitCube()).boundaryLoops().empty());
}

TEST(MeshTopology, CountsComponents)
{
  EXPECT_EQ(MeshTopology(SurfaceMesh()).componentCount(), 0);
  EXPECT_EQ(MeshTopology(unitCube()).componentCount(), 1);
  EXPECT_EQ(MeshTopology(merged(merged(fan(5), unitCube()), annulus(4))).componentCount(), 3);
}

TEST(MeshTopology, RingOfADiscGoesRoundOnce)
{
  const MeshTopology topology(fan(6));
  const MeshTopology::Run ring = topology.ringVertices(0);
  EXPECT_EQ(std::vector<Index>(ring.begin(), ring.end()), (std::vector<Index>{ 1, 2, 3, 4, 5, 6 }));
  const MeshTopology::Run half = topology.ringVertices(2);
  EXPECT_EQ(std::vector<Index>(half.begin(), half.end()), (std::vector<Index>{ 3, 0, 1 }));
}

} // namespace

} // namespace evolving
