// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/DirectedEdges.h"

#include <algorithm>
#include <tuple>

namespace evolving
{

std::vector<DirectedEdge> sortedDirectedEdges(const SurfaceMesh& mesh)
{
  std::vector<DirectedEdge> edges;
  edges.reserve(mesh.cornerVertices.size());
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    const Index offset = mesh.faceOffsets[static_cast<std::size_t>(face)];
    const Index size = mesh.faceSize(face);
    for (Index k = 0; k < size; ++k)
    {
      const Index next = (k + 1) % size;
      const Index a = mesh.faceVertex(face, k);
      const Index b = mesh.faceVertex(face, next);
      edges.push_back({ std::min(a, b), std::max(a, b), offset + k, offset + next, a < b });
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const DirectedEdge& p, const DirectedEdge& q)
    { return std::tie(p.low, p.high, p.corner) < std::tie(q.low, q.high, q.corner); });
  return edges;
}

} // namespace evolving
