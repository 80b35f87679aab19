// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/DirectedEdges.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>

namespace evolving
{

namespace
{

std::vector<DirectedEdge> directedEdges(const SurfaceMesh& mesh)
{
  std::vector<DirectedEdge> edges;
  edges.reserve(mesh.cornerVertices.size());
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    const Index offset = mesh.faceOffsets[static_cast<std::size_t>(face)];
    const Index size = mesh.faceSize(face);
    for (Index k = 0; k < size; ++k)
    {
      const Index next = k + 1 < size ? k + 1 : 0;
      const Index a = mesh.faceVertex(face, k);
      const Index b = mesh.faceVertex(face, next);
      edges.push_back({ std::min(a, b), std::max(a, b), offset + k, offset + next, a < b });
    }
  }
  return edges;
}

} // namespace

/// By counting: a vertex has few edges, which are soon sorted.
std::vector<DirectedEdge> sortedDirectedEdges(const SurfaceMesh& mesh)
{
  const std::vector<DirectedEdge> edges = directedEdges(mesh);
  std::vector<std::size_t> begin(mesh.points.size() + 1, 0);
  const auto beginOf = [&begin](Index low) -> std::size_t&
  { return begin[static_cast<std::size_t>(low)]; };
  for (const DirectedEdge& edge : edges)
  {
    ++beginOf(edge.low + 1);
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<DirectedEdge> sorted(edges.size());
  for (const DirectedEdge& edge : edges)
  {
    sorted[beginOf(edge.low)++] = edge; // from now on a vertex's begin is its end
  }
  std::size_t first = 0;
  for (const std::size_t last : begin)
  {
    std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(first),
      sorted.begin() + static_cast<std::ptrdiff_t>(last),
      [](const DirectedEdge& p, const DirectedEdge& q)
      { return std::tie(p.high, p.corner) < std::tie(q.high, q.corner); });
    first = last;
  }
  return sorted;
}

} // namespace evolving
