// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "UmbrellaSmoothing.h"

#include "Mesh/MeshTopology.h"
#include "Mesh/VertexNormals.h"

namespace benchmark
{

namespace
{

using evolving::Index;
using evolving::Vec3;

/// From a vertex to the mean of its neighbours.
Vec3 umbrella(
  const evolving::SurfaceMesh& mesh, const evolving::MeshTopology& topology, Index vertex)
{
  const auto ring = topology.ringVertices(vertex);
  Vec3 sum = Vec3::Zero();
  for (const Index neighbour : ring)
  {
    sum += mesh.points[static_cast<std::size_t>(neighbour)];
  }
  return sum / ring.size() - mesh.points[static_cast<std::size_t>(vertex)];
}

/// All points at once, from the same state.
void iterate(evolving::SurfaceMesh& mesh, const evolving::MeshTopology& topology,
  const evolving::AABBTree& surface, const UmbrellaSmoothing& smoothing)
{
  const std::vector<Vec3> normals = evolving::angleWeightedNormals(mesh, topology);
  std::vector<Vec3> moved = mesh.points;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    const auto i = static_cast<std::size_t>(v);
    if (topology.isBoundary(v) || !topology.isUsed(v))
    {
      continue;
    }
    Vec3 move = umbrella(mesh, topology, v);
    if (smoothing.tangential)
    {
      move -= move.dot(normals[i]) * normals[i];
    }
    moved[i] = surface.closest(mesh.points[i] + smoothing.factor * move).at.point;
  }
  mesh.points = std::move(moved);
}

} // namespace

evolving::SurfaceMesh smoothed(const evolving::SurfaceMesh& mesh, const evolving::AABBTree& surface,
  const UmbrellaSmoothing& smoothing)
{
  const evolving::MeshTopology topology(mesh);
  evolving::SurfaceMesh result = mesh;
  for (int i = 0; i < smoothing.iterations; ++i)
  {
    iterate(result, topology, surface, smoothing);
  }
  return result;
}

} // namespace benchmark
