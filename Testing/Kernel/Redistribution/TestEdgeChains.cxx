// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/MeshTopology.h"
#include "Redistribution/EdgeChains.h"
#include "Shapes/Sheets.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace evolving;

TEST(EdgeChains, AreTheGridLinesOfATorus)
{
  const SurfaceMesh quads = shapes::quadTorus(10, 6, 2.0, 0.7);
  const MeshTopology topology(quads);
  const std::vector<VertexChain> chains = edgeChains(topology, SurfaceCurves(quads, topology));
  std::map<Index, int> lengths;
  for (const VertexChain& chain : chains)
  {
    EXPECT_TRUE(chain.isClosed);
    ++lengths[chain.edgeCount()];
  }
  EXPECT_EQ(lengths, (std::map<Index, int>{ { 10, 6 }, { 6, 10 } }));
}

TEST(EdgeChains, CoverEveryInnerEdgeOnce)
{
  for (const SurfaceMesh& mesh :
    { icosphere(2), cubeSphere(5), shapes::sheet(6, true), shapes::torus(9, 7, 2.0, 0.7) })
  {
    const MeshTopology topology(mesh);
    std::multiset<std::pair<Index, Index>> seen;
    for (const VertexChain& chain : edgeChains(topology, SurfaceCurves(mesh, topology)))
    {
      for (Index k = 0; k < chain.edgeCount(); ++k)
      {
        seen.insert(std::minmax({ chain.vertex(k), chain.vertex(k + 1) }));
      }
    }
    std::size_t inner = 0;
    for (Index corner = 0; corner < topology.cornerCount(); ++corner)
    {
      if (topology.opposite(corner) > corner)
      {
        ++inner;
        EXPECT_EQ(seen.count(std::minmax(
                    { topology.vertexOf(corner), topology.vertexOf(topology.next(corner)) })),
          1u);
      }
    }
    EXPECT_EQ(seen.size(), inner);
  }
}

TEST(EdgeChains, EndAfterTheirLongestLength)
{
  constexpr Index Rest = 2000;
  constexpr Index Around = LongestChain + Rest;
  const SurfaceMesh mesh = shapes::quadTorus(Around, 3, 2.0, 0.01);
  const MeshTopology topology(mesh);
  std::map<Index, int> lengths;
  for (const VertexChain& chain : edgeChains(topology, SurfaceCurves(mesh, topology)))
  {
    ++lengths[chain.edgeCount()];
  }
  EXPECT_EQ(lengths, (std::map<Index, int>{ { 3, Around }, { LongestChain, 3 }, { Rest, 3 } }));
}

TEST(EdgeChains, EndAtIrregularVertices)
{
  const SurfaceMesh mesh = icosphere(2); // edges of the icosahedron: chains of four
  const MeshTopology topology(mesh);
  int fromIrregular = 0;
  for (const VertexChain& chain : edgeChains(topology, SurfaceCurves(mesh, topology)))
  {
    const auto isIrregular = [&](Index v) { return topology.ringCorners(v).size() == 5; };
    if (!chain.isClosed)
    {
      EXPECT_TRUE(isIrregular(chain.vertices.front()));
      EXPECT_TRUE(isIrregular(chain.vertices.back()));
      EXPECT_EQ(chain.edgeCount(), 4);
      ++fromIrregular;
    }
  }
  EXPECT_EQ(fromIrregular, 30);
}
