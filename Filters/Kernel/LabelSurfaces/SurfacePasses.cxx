// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/SurfacePasses.h"

#include "ParallelLoops.h"

#include <algorithm>
#include <numeric>

namespace evolving
{

SurfacePasses::SurfacePasses(const InterfaceNet& net, const InterfaceTriangles& triangles,
  Index vertexCount, const Execution& execution)
  : Net(net)
  , Triangles(triangles)
  , Corners(cornersOfVertices(triangles, vertexCount))
  , Passes(2 * triangles.corners.size(), NoIndex)
{
  // Numbered at each vertex first, then by those before.
  std::vector<Index> offsets(at(vertexCount) + 1, 0);
  execution.phase(0.0, 0.8).forRangeReporting(vertexCount, Execution::MeshGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto vertex = static_cast<Index>(begin); vertex < end; ++vertex)
      {
        for (const Wedge& wedge : this->wedgesAt(vertex))
        {
          this->Passes[at(2 * wedge.corner + wedge.side)] = wedge.pass;
          offsets[at(vertex) + 1] = std::max(offsets[at(vertex) + 1], wedge.pass + 1);
        }
      }
    });
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  this->Vertices.resize(at(offsets.back()));
  this->Labels.resize(at(offsets.back()));
  forEachIndex(
    execution, vertexCount, [&](Index vertex) { this->renumberAt(vertex, offsets[at(vertex)]); });
}

void SurfacePasses::renumberAt(Index vertex, Index offset)
{
  for (Index k = this->Corners.offsets[at(vertex)]; k < this->Corners.offsets[at(vertex) + 1]; ++k)
  {
    const Index corner = this->Corners.corners[at(k)];
    for (const Index side : { 0, 1 })
    {
      Index& pass = this->Passes[at(2 * corner + side)];
      if (pass != NoIndex)
      {
        pass += offset;
        this->Vertices[at(pass)] = vertex;
        this->Labels[at(pass)] = this->quadOf(corner).sides[at(side)];
      }
    }
  }
}

const NetQuad& SurfacePasses::quadOf(Index corner) const
{
  return this->Net.quads[at(this->Triangles.quads[at(corner / 3)])];
}

std::vector<SurfacePasses::Wedge> SurfacePasses::wedgesAt(Index vertex) const
{
  std::vector<Wedge> wedges;
  for (Index k = this->Corners.offsets[at(vertex)]; k < this->Corners.offsets[at(vertex) + 1]; ++k)
  {
    const Index corner = this->Corners.corners[at(k)];
    const Index first = corner - corner % 3;
    const std::array<Index, 2> ends = { this->Triangles.corners[at(first + (corner + 1) % 3)],
      this->Triangles.corners[at(first + (corner + 2) % 3)] };
    const NetQuad& quad = this->quadOf(corner);
    for (const Index side : { 0, 1 })
    {
      if (isLabel(quad.sides[at(side)]))
      {
        wedges.push_back({ quad.sides[at(side)], corner, side, quad.voxels[at(side)], ends, 0 });
      }
    }
  }
  join(wedges);
  return wedges;
}

bool SurfacePasses::hasEnd(const Wedge& wedge, Index end)
{
  return wedge.ends[0] == end || wedge.ends[1] == end;
}

/// The wedges of the same label along the edge to an end: two or four.
std::ptrdiff_t SurfacePasses::countAlong(
  const std::vector<Wedge>& wedges, const Wedge& wedge, Index end)
{
  return std::count_if(wedges.begin(), wedges.end(),
    [&](const Wedge& one) { return one.label == wedge.label && hasEnd(one, end); });
}

bool SurfacePasses::areJoined(const std::vector<Wedge>& wedges, const Wedge& a, const Wedge& b)
{
  return a.label == b.label &&
    std::any_of(a.ends.begin(), a.ends.end(),
      [&](Index end)
      { return hasEnd(b, end) && (a.voxel == b.voxel || countAlong(wedges, a, end) == 2); });
}

/// Spreads from wedge to wedge; the passes get the order of their first wedges.
void SurfacePasses::join(std::vector<Wedge>& wedges)
{
  Index passes = 0;
  std::vector<std::size_t> reached;
  std::vector<char> isReached(wedges.size(), 0);
  for (std::size_t first = 0; first < wedges.size(); ++first)
  {
    if (isReached[first] != 0)
    {
      continue;
    }
    reached.assign(1, first);
    isReached[first] = 1;
    while (!reached.empty())
    {
      const std::size_t from = reached.back();
      reached.pop_back();
      wedges[from].pass = passes;
      for (std::size_t to = 0; to < wedges.size(); ++to)
      {
        if (isReached[to] == 0 && areJoined(wedges, wedges[from], wedges[to]))
        {
          isReached[to] = 1;
          reached.push_back(to);
        }
      }
    }
    ++passes;
  }
}

/// The pass of a wedge's triangle at another of its vertices.
Index SurfacePasses::passAtEnd(const Wedge& wedge, Index end) const
{
  const Index first = wedge.corner - wedge.corner % 3;
  const Index k = wedge.ends[0] == end ? 1 : 2;
  return this->pass(first + (wedge.corner + k) % 3, wedge.side);
}

bool SurfacePasses::isAmbiguous(
  const std::vector<Wedge>& wedges, const Wedge& wedge, Index end) const
{
  return std::any_of(wedges.begin(), wedges.end(),
    [&](const Wedge& one)
    {
      return one.label == wedge.label && one.voxel != wedge.voxel && hasEnd(one, end) &&
        countAlong(wedges, wedge, end) == 4 && one.pass == wedge.pass &&
        this->passAtEnd(one, end) == this->passAtEnd(wedge, end);
    });
}

std::vector<NetEdge> SurfacePasses::ambiguousEdges(const Execution& execution) const
{
  const auto vertexCount = static_cast<Index>(this->Corners.offsets.size()) - 1;
  std::vector<std::vector<NetEdge>> found(
    static_cast<std::size_t>((vertexCount + LoopGrain - 1) / LoopGrain));
  forEachIndex(execution, vertexCount,
    [&](Index vertex)
    {
      const std::vector<Wedge> wedges = this->wedgesAt(vertex);
      for (const Wedge& wedge : wedges)
      {
        for (const Index end : wedge.ends)
        {
          if (vertex < end && this->isAmbiguous(wedges, wedge, end))
          {
            found[at(vertex / LoopGrain)].push_back({ vertex, end });
          }
        }
      }
    });
  std::vector<NetEdge> edges;
  for (const std::vector<NetEdge>& part : found)
  {
    edges.insert(edges.end(), part.begin(), part.end());
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

} // namespace evolving
