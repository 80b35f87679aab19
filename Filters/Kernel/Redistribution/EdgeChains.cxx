// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/EdgeChains.h"

#include "ParallelLoops.h"

#include <algorithm>

namespace evolving
{

namespace
{

Index sizeOfFace(const MeshTopology& topology, Index corner)
{
  Index size = 1;
  for (Index c = topology.next(corner); c != corner; c = topology.next(c))
  {
    ++size;
  }
  return size;
}

bool isRegular(const MeshTopology& topology, Index vertex)
{
  const MeshTopology::Run ring = topology.ringCorners(vertex);
  const Index wanted = ring.size() == 6 ? 3 : 4;
  return !topology.isBoundary(vertex) && (ring.size() == 6 || ring.size() == 4) &&
    std::all_of(ring.begin(), ring.end(),
      [&](Index corner) { return sizeOfFace(topology, corner) == wanted; });
}

/// A directed edge is the corner it starts from, as in MeshTopology.
class Tracer
{
public:
  Tracer(const MeshTopology& topology, const SurfaceCurves& curves)
    : Topology(topology)
    , Curves(curves)
    , Taken(at(topology.cornerCount()), 0)
  {
  }

  /// The chain of an edge.
  VertexChain trace(Index edge)
  {
    VertexChain chain;
    this->Length = 1;
    this->take(edge);
    std::vector<Index> forward = { edge };
    std::vector<Index> backward = { this->Topology.opposite(edge) };
    chain.isClosed = this->extend(forward);
    if (!chain.isClosed)
    {
      this->extend(backward);
    }
    for (auto e = backward.rbegin(); e + 1 != backward.rend(); ++e)
    {
      chain.vertices.push_back(this->endOf(*e));
    }
    chain.vertices.push_back(this->Topology.vertexOf(edge));
    for (const Index e : forward)
    {
      chain.vertices.push_back(this->endOf(e));
    }
    if (chain.isClosed)
    {
      chain.vertices.pop_back(); // the first vertex again
    }
    return chain;
  }

  bool isTaken(Index edge) const { return this->Taken[at(edge)] != 0; }

private:
  Index endOf(Index edge) const { return this->Topology.vertexOf(this->Topology.next(edge)); }

  void take(Index edge)
  {
    this->Taken[at(edge)] = 1;
    this->Taken[at(this->Topology.opposite(edge))] = 1;
  }

  /// The edge opposite to the last one at its end, or NoIndex.
  Index successor(Index edge) const
  {
    const Index vertex = this->endOf(edge);
    if (this->Curves.isOnCurve(vertex) || !isRegular(this->Topology, vertex))
    {
      return NoIndex;
    }
    const MeshTopology::Run ring = this->Topology.ringCorners(vertex);
    const auto arrival = std::find(ring.begin(), ring.end(), this->Topology.opposite(edge));
    const auto k = static_cast<Index>(arrival - ring.begin());
    return ring[(k + ring.size() / 2) % ring.size()];
  }

  /// Appends edges; true when the next one would be the first again.
  bool extend(std::vector<Index>& edges)
  {
    for (;;)
    {
      const Index next = this->successor(edges.back());
      if (next == edges.front())
      {
        return true;
      }
      if (next == NoIndex || this->isTaken(next) || this->Length >= LongestChain)
      {
        return false;
      }
      this->take(next);
      edges.push_back(next);
      ++this->Length;
    }
  }

  const MeshTopology& Topology;
  const SurfaceCurves& Curves;
  std::vector<char> Taken;
  Index Length = 0; ///< of the chain being traced, in edges
};

} // namespace

std::vector<VertexChain> edgeChains(const MeshTopology& topology, const SurfaceCurves& curves)
{
  Tracer tracer(topology, curves);
  std::vector<VertexChain> chains;
  for (Index edge = 0; edge < topology.cornerCount(); ++edge)
  {
    const bool isBoundary = topology.opposite(edge) == NoIndex;
    if (!isBoundary && !tracer.isTaken(edge))
    {
      chains.push_back(tracer.trace(edge));
    }
  }
  return chains;
}

} // namespace evolving
