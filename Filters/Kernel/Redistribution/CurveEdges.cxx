// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/CurveEdges.h"

#include "Mesh/Angles.h"
#include "Mesh/DisjointSets.h"
#include "ParallelLoops.h"

#include <algorithm>
#include <cstdint>

namespace evolving
{

namespace
{

constexpr Index EdgesOfACurve = 12;
constexpr Index PartOfCoarseMesh = 4; ///< a quarter of its edges

bool isSharp(
  const SurfaceMesh& mesh, const MeshTopology& topology, Index corner, double creaseAngle)
{
  const Vec3 here = faceVectorArea(mesh, topology.faceOf(corner));
  const Vec3 there = faceVectorArea(mesh, topology.faceOf(topology.opposite(corner)));
  return angleBetween(here, there) > creaseAngle * RadiansPerDegree;
}

/// One corner for each edge of the boundary and each sharp one.
std::vector<Index> candidates(
  const SurfaceMesh& mesh, const MeshTopology& topology, double creaseAngle)
{
  std::vector<Index> corners;
  for (Index corner = 0; corner < topology.cornerCount(); ++corner)
  {
    const Index opposite = topology.opposite(corner);
    if (opposite == NoIndex || (corner > opposite && isSharp(mesh, topology, corner, creaseAngle)))
    {
      corners.push_back(corner);
    }
  }
  return corners;
}

/// How many candidates are connected to a vertex; one at the boundary is enough.
class ConnectedEdges
{
public:
  ConnectedEdges(const MeshTopology& topology, const std::vector<Index>& corners)
    : Sets(at(topology.vertexCount()))
    , Edges(at(topology.vertexCount()), 0)
    , Enough(std::min(EdgesOfACurve, topology.cornerCount() / 2 / PartOfCoarseMesh))
  {
    for (const Index corner : corners)
    {
      this->Sets.join(topology.vertexOf(corner), topology.vertexOf(topology.next(corner)));
    }
    for (const Index corner : corners)
    {
      const bool isBoundary = topology.opposite(corner) == NoIndex;
      this->Edges[at(this->Sets.find(topology.vertexOf(corner)))] += isBoundary ? EdgesOfACurve : 1;
    }
  }
  bool makeCurve(Index vertex) { return this->Edges[at(this->Sets.find(vertex))] >= this->Enough; }

private:
  DisjointSets Sets;
  std::vector<std::int64_t> Edges;
  Index Enough;
};

} // namespace

std::vector<std::vector<Index>> curveNeighbours(
  const SurfaceMesh& mesh, const MeshTopology& topology, double creaseAngle)
{
  const std::vector<Index> corners = candidates(mesh, topology, creaseAngle);
  ConnectedEdges connected(topology, corners);
  std::vector<std::vector<Index>> neighbours(mesh.points.size());
  for (const Index corner : corners)
  {
    const Index a = topology.vertexOf(corner);
    const Index b = topology.vertexOf(topology.next(corner));
    if (connected.makeCurve(a))
    {
      neighbours[at(a)].push_back(b);
      neighbours[at(b)].push_back(a);
    }
  }
  return neighbours;
}

} // namespace evolving
