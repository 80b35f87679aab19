// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/BoundaryCycles.h"

#include "Mesh/DirectedEdges.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace evolving
{

namespace
{

std::vector<RimEdge> rimEdges(const SurfaceMesh& mesh)
{
  const std::vector<DirectedEdge> edges = sortedDirectedEdges(mesh);
  std::vector<RimEdge> rim;
  forEachEdge(edges,
    [&](std::size_t first, std::size_t last)
    {
      if (last - first == 1 && edges[first].low != edges[first].high)
      {
        const DirectedEdge& edge = edges[first];
        const auto above =
          std::upper_bound(mesh.faceOffsets.begin(), mesh.faceOffsets.end(), edge.corner);
        const auto face = static_cast<Index>(above - mesh.faceOffsets.begin()) - 1;
        rim.push_back(
          { edge.forward ? edge.low : edge.high, edge.forward ? edge.high : edge.low, face });
      }
    });
  return rim;
}

/// Walks along edges not used before; what the walk encloses when it meets itself is a cycle.
class CycleWalk
{
public:
  CycleWalk(const std::vector<RimEdge>& edges, Index vertexCount)
    : Edges(edges)
    , Used(edges.size(), 0)
    , EdgesAt(at(vertexCount))
    , PositionOf(at(vertexCount), NoIndex)
  {
    for (std::size_t e = 0; e < edges.size(); ++e)
    {
      this->EdgesAt[at(edges[e].from)].push_back(static_cast<Index>(e));
      this->EdgesAt[at(edges[e].to)].push_back(static_cast<Index>(e));
    }
    for (std::vector<Index>& edgesHere : this->EdgesAt)
    {
      std::reverse(edgesHere.begin(), edgesHere.end()); // they are taken from the back
    }
  }

  std::vector<RimCycle> run()
  {
    for (const RimEdge& edge : this->Edges)
    {
      this->enter(std::min(edge.from, edge.to), NoIndex);
      while (!this->Path.empty())
      {
        this->step();
      }
    }
    return std::move(this->Cycles);
  }

private:
  struct Stop
  {
    Index vertex;
    Index edge; ///< by which the walk came
  };

  void enter(Index vertex, Index edge)
  {
    this->PositionOf[at(vertex)] = static_cast<Index>(this->Path.size());
    this->Path.push_back({ vertex, edge });
  }
  void leave()
  {
    this->PositionOf[at(this->Path.back().vertex)] = NoIndex;
    this->Path.pop_back();
  }

  /// One edge on, or one back where the walk is at a dead end.
  void step()
  {
    const Index here = this->Path.back().vertex;
    const Index edge = this->takeEdgeAt(here);
    if (edge == NoIndex)
    {
      this->leave();
      return;
    }
    const Index next = this->Edges[at(edge)].otherEnd(here);
    if (this->PositionOf[at(next)] == NoIndex)
    {
      this->enter(next, edge);
    }
    else
    {
      this->close(at(this->PositionOf[at(next)]), edge);
    }
  }

  Index takeEdgeAt(Index vertex)
  {
    std::vector<Index>& candidates = this->EdgesAt[at(vertex)];
    while (!candidates.empty())
    {
      const Index edge = candidates.back();
      candidates.pop_back();
      if (!this->Used[at(edge)])
      {
        this->Used[at(edge)] = 1;
        return edge;
      }
    }
    return NoIndex;
  }

  /// The path from a position on is a cycle, closed by an edge; the walk goes on before it.
  void close(std::size_t position, Index lastEdge)
  {
    RimCycle cycle;
    for (std::size_t p = position; p < this->Path.size(); ++p)
    {
      cycle.vertices.push_back(this->Path[p].vertex);
      if (p > position)
      {
        cycle.edges.push_back(this->Edges[at(this->Path[p].edge)]);
      }
    }
    cycle.edges.push_back(this->Edges[at(lastEdge)]);
    this->Cycles.push_back(std::move(cycle));
    while (this->Path.size() > position + 1)
    {
      this->leave();
    }
  }

  const std::vector<RimEdge>& Edges;
  std::vector<char> Used;
  std::vector<std::vector<Index>> EdgesAt; ///< not looked at yet
  std::vector<Index> PositionOf;           ///< of vertices on the path
  std::vector<Stop> Path;
  std::vector<RimCycle> Cycles;
};

} // namespace

std::vector<RimCycle> boundaryCycles(const SurfaceMesh& mesh)
{
  const std::vector<RimEdge> edges = rimEdges(mesh);
  return CycleWalk(edges, mesh.vertexCount()).run();
}

} // namespace evolving
