// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/TopologySummary.h"

#include "Mesh/ConnectedComponents.h"
#include "Mesh/DirectedEdges.h"
#include "Mesh/DisjointSets.h"

#include <algorithm>
#include <vector>

namespace evolving
{

namespace
{

void countEdges(const std::vector<DirectedEdge>& edges, TopologySummary& summary)
{
  forEachEdge(edges,
    [&](std::size_t first, std::size_t last)
    {
      const std::size_t faces = last - first;
      summary.edges += 1;
      summary.boundaryEdges += faces == 1 ? 1 : 0;
      summary.nonManifoldEdges += faces > 2 ? 1 : 0;
      summary.flippedEdges +=
        faces == 2 && edges[first].forward == edges[first + 1].forward ? 1 : 0;
    });
}

/// A fan is what the corners at a vertex become when those that share an edge are joined.
Index countVerticesWithSeveralFans(const SurfaceMesh& mesh, const std::vector<DirectedEdge>& edges)
{
  DisjointSets fans(mesh.cornerVertices.size());
  forEachEdge(edges,
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first + 1; i < last; ++i)
      {
        fans.join(edges[first].cornerAtLow(), edges[i].cornerAtLow());
        fans.join(edges[first].cornerAtHigh(), edges[i].cornerAtHigh());
      }
    });
  std::vector<Index> fansAt(mesh.points.size(), 0);
  for (Index corner = 0; corner < mesh.cornerCount(); ++corner)
  {
    if (fans.find(corner) == corner)
    {
      ++fansAt[static_cast<std::size_t>(mesh.cornerVertices[static_cast<std::size_t>(corner)])];
    }
  }
  return static_cast<Index>(
    std::count_if(fansAt.begin(), fansAt.end(), [](Index count) { return count > 1; }));
}

} // namespace

TopologySummary summarizeTopology(const SurfaceMesh& mesh)
{
  TopologySummary summary;
  const std::vector<DirectedEdge> edges = sortedDirectedEdges(mesh);
  countEdges(edges, summary);
  summary.nonManifoldVertices = countVerticesWithSeveralFans(mesh, edges);
  const ConnectedComponents components = connectedComponents(mesh);
  summary.components = components.count;
  summary.faces = mesh.faceCount();
  summary.usedVertices = static_cast<Index>(std::count_if(components.ofVertex.begin(),
    components.ofVertex.end(), [](Index component) { return component != NoIndex; }));
  return summary;
}

} // namespace evolving
