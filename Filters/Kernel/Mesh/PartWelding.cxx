// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/PartWelding.h"

#include "Mesh/ConnectedComponents.h"
#include "Mesh/DirectedEdges.h"
#include "Mesh/PointWelding.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace evolving
{

namespace
{

bool hasCornersAtOnePlace(const SurfaceMesh& mesh, Index face)
{
  const Index size = mesh.faceSize(face);
  for (Index k = 0; k < size; ++k)
  {
    for (Index l = 0; l < k; ++l)
    {
      if (mesh.facePoint(face, k) == mesh.facePoint(face, l))
      {
        return true;
      }
    }
  }
  return false;
}

/// A flag for every part.
std::vector<char> closedParts(const SurfaceMesh& mesh, const ConnectedComponents& parts)
{
  std::vector<char> isClosed(at(parts.count), 1);
  const auto partOf = [&](Index vertex) { return at(parts.ofVertex[at(vertex)]); };
  const std::vector<DirectedEdge> edges = sortedDirectedEdges(mesh);
  forEachEdge(edges,
    [&](std::size_t first, std::size_t last)
    {
      const bool areTwo = last - first == 2 && edges[first].forward != edges[first + 1].forward;
      if (!areTwo)
      {
        isClosed[partOf(edges[first].low)] = 0;
      }
    });
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    if (hasCornersAtOnePlace(mesh, face))
    {
      isClosed[partOf(mesh.faceVertex(face, 0))] = 0;
    }
  }
  return isClosed;
}

} // namespace

std::vector<Index> verticesToJoin(const SurfaceMesh& mesh)
{
  const ConnectedComponents parts = connectedComponents(mesh);
  const std::vector<char> isClosed = closedParts(mesh, parts);
  std::vector<Index> used = usedVertices(mesh);
  const auto firstClosed = std::stable_partition(used.begin(), used.end(),
    [&](Index vertex) { return isClosed[at(parts.ofVertex[at(vertex)])] == 0; });
  const std::vector<Index> ofClosed(firstClosed, used.end());
  used.erase(firstClosed, used.end());
  std::vector<Index> first = firstOfEqualPoints(mesh.points, std::move(used));
  for (const Index vertex : ofClosed)
  {
    first[at(vertex)] = vertex;
  }
  return first;
}

SurfaceMesh weldOpenParts(
  const SurfaceMesh& mesh, std::vector<Index>* oldVertex, std::vector<Index>* oldFace)
{
  return joinVertices(mesh, verticesToJoin(mesh), oldVertex, oldFace);
}

} // namespace evolving
