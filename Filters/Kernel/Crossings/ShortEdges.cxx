// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/ShortEdges.h"

#include "Mesh/DisjointSets.h"
#include "Mesh/TopologySummary.h"
#include "Mesh/TriangleEdges.h"

namespace evolving
{

SurfaceMesh withoutShortEdges(const SurfaceMesh& surface, double length)
{
  const TriangleEdges edges(surface);
  DisjointSets same(at(surface.vertexCount()));
  for (Index edge = 0; edge < edges.edgeCount(); ++edge)
  {
    const Index corner = *edges.begin(edge);
    const Index a = surface.cornerVertices[at(corner)];
    const Index b = surface.cornerVertices[at(TriangleEdges::nextCorner(corner))];
    if ((surface.points[at(a)] - surface.points[at(b)]).norm() < length)
    {
      same.join(a, b);
    }
  }
  SurfaceMesh joined = surface;
  for (Index& vertex : joined.cornerVertices)
  {
    vertex = same.find(vertex);
  }
  joined = weldCoincidentPoints(joined);
  const bool isPinched =
    summarizeTopology(surface).isClosed() && !summarizeTopology(joined).isClosed();
  return isPinched ? surface : joined;
}

} // namespace evolving
