// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/MeshTopology.h"

#include "Errors.h"
#include "Mesh/ConnectedComponents.h"
#include "Mesh/DirectedEdges.h"

#include <algorithm>
#include <numeric>
#include <sstream>
#include <utility>

namespace evolving
{

namespace
{

[[noreturn]] void throwBadEdge(const DirectedEdge& edge, std::size_t faces)
{
  std::ostringstream message;
  if (edge.low == edge.high)
  {
    message << "An edge joins point " << edge.low << " to itself, expected two different points";
  }
  else if (faces > 2)
  {
    message << "The edge between points " << edge.low << " and " << edge.high << " belongs to "
            << faces << " faces, expected at most 2 (a manifold surface)";
  }
  else
  {
    message << "The two faces at the edge between points " << edge.low << " and " << edge.high
            << " have opposite orientations, expected consistent ones";
  }
  message << "; repair the mesh, or use Shrink Wrap, which takes any mesh.";
  throw InputError(message.str());
}

[[noreturn]] void throwSeveralFans(Index vertex)
{
  std::ostringstream message;
  message << "Several separate fans of faces meet at point " << vertex
          << ", expected one (a manifold surface); split the point, or use Shrink Wrap, which "
             "takes any mesh.";
  throw InputError(message.str());
}

} // namespace

MeshTopology::MeshTopology(const SurfaceMesh& mesh)
  : FaceOffsets(mesh.faceOffsets)
  , Vertex(mesh.cornerVertices)
  , Face(mesh.cornerVertices.size())
  , Opposite(mesh.cornerVertices.size(), NoIndex)
  , BoundaryVertex(mesh.points.size(), 0)
{
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    std::fill(this->Face.begin() + this->FaceOffsets[at(face)],
      this->Face.begin() + this->FaceOffsets[at(face) + 1], face);
  }
  this->joinOpposites(mesh);
  this->sortRings();
  this->traceBoundaryLoops();
  ConnectedComponents components = connectedComponents(mesh);
  this->Component = std::move(components.ofVertex);
  this->Components = components.count;
}

Index MeshTopology::next(Index corner) const
{
  const Index face = this->faceOf(corner);
  return corner + 1 < this->FaceOffsets[at(face) + 1] ? corner + 1 : this->FaceOffsets[at(face)];
}

Index MeshTopology::previous(Index corner) const
{
  const Index face = this->faceOf(corner);
  return corner > this->FaceOffsets[at(face)] ? corner - 1 : this->FaceOffsets[at(face) + 1] - 1;
}

MeshTopology::Run MeshTopology::ringCorners(Index vertex) const
{
  const Index* corners = this->RingCorner.data();
  return { corners + this->RingOffsets[at(vertex)], corners + this->RingOffsets[at(vertex) + 1] };
}

MeshTopology::Run MeshTopology::ringVertices(Index vertex) const
{
  const Index* vertices = this->Neighbour.data();
  return { vertices + this->NeighbourOffsets[at(vertex)],
    vertices + this->NeighbourOffsets[at(vertex) + 1] };
}

void MeshTopology::joinOpposites(const SurfaceMesh& mesh)
{
  const std::vector<DirectedEdge> edges = sortedDirectedEdges(mesh);
  forEachEdge(edges,
    [&](std::size_t first, std::size_t last)
    {
      const std::size_t faces = last - first;
      const bool flipped = faces == 2 && edges[first].forward == edges[first + 1].forward;
      if (faces > 2 || flipped || edges[first].low == edges[first].high)
      {
        throwBadEdge(edges[first], faces);
      }
      if (faces == 2)
      {
        this->Opposite[at(edges[first].corner)] = edges[first + 1].corner;
        this->Opposite[at(edges[first + 1].corner)] = edges[first].corner;
      }
    });
}

/// For each vertex the corner whose edge is a boundary edge, or else its smallest corner.
std::vector<Index> MeshTopology::findRingStarts()
{
  std::vector<Index> starts(this->BoundaryVertex.size(), NoIndex);
  for (Index corner = 0; corner < this->cornerCount(); ++corner)
  {
    const Index v = this->vertexOf(corner);
    if (this->opposite(corner) == NoIndex)
    {
      if (this->isBoundary(v))
      {
        throwSeveralFans(v);
      }
      this->BoundaryVertex[at(v)] = 1;
      starts[at(v)] = corner;
    }
    else if (starts[at(v)] == NoIndex)
    {
      starts[at(v)] = corner;
    }
  }
  return starts;
}

void MeshTopology::sortRings()
{
  const std::vector<Index> starts = this->findRingStarts();
  this->RingOffsets.assign(starts.size() + 1, 0);
  for (const Index v : this->Vertex)
  {
    ++this->RingOffsets[at(v) + 1];
  }
  std::partial_sum(this->RingOffsets.begin(), this->RingOffsets.end(), this->RingOffsets.begin());
  this->RingCorner.reserve(this->Vertex.size());
  this->Neighbour.reserve(this->Vertex.size());
  this->NeighbourOffsets.assign(1, 0);
  for (Index v = 0; v < this->vertexCount(); ++v)
  {
    this->walkRing(starts[at(v)]);
    if (static_cast<Index>(this->RingCorner.size()) != this->RingOffsets[at(v) + 1])
    {
      throwSeveralFans(v);
    }
    this->NeighbourOffsets.push_back(static_cast<Index>(this->Neighbour.size()));
  }
}

void MeshTopology::walkRing(Index start)
{
  // Counter-clockwise: from the edge to the next vertex, over the edge from the previous one.
  for (Index corner = start; corner != NoIndex;)
  {
    this->RingCorner.push_back(corner);
    this->Neighbour.push_back(this->vertexOf(this->next(corner)));
    const Index incoming = this->previous(corner);
    corner = this->opposite(incoming);
    if (corner == NoIndex)
    {
      this->Neighbour.push_back(this->vertexOf(incoming));
    }
    corner = corner == start ? NoIndex : corner;
  }
}

void MeshTopology::traceBoundaryLoops()
{
  std::vector<char> seen(this->BoundaryVertex.size(), 0);
  for (Index v = 0; v < this->vertexCount(); ++v)
  {
    if (!this->isBoundary(v) || seen[at(v)])
    {
      continue;
    }
    std::vector<Index> loop;
    // A boundary vertex has one fan, so its first ring corner is its only boundary edge.
    for (Index u = v; !seen[at(u)]; u = this->vertexOf(this->next(this->ringCorners(u)[0])))
    {
      seen[at(u)] = 1;
      loop.push_back(u);
    }
    this->Loops.push_back(std::move(loop));
  }
}

} // namespace evolving
