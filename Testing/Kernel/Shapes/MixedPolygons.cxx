// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Shapes/MixedPolygons.h"

#include "Mesh/MeshTopology.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <algorithm>
#include <vector>

namespace evolving::shapes
{

SurfaceMesh withPolygons(const SurfaceMesh& triangles, Index period)
{
  const MeshTopology topology(triangles);
  std::vector<char> isJoined(static_cast<std::size_t>(triangles.faceCount()), 0);
  SurfaceMesh mesh;
  mesh.points = triangles.points;
  for (Index i = 0; i < triangles.vertexCount(); i += period)
  {
    const MeshTopology::Run corners = topology.ringCorners(i);
    const auto joined = [&](Index corner) -> char&
    { return isJoined[static_cast<std::size_t>(topology.faceOf(corner))]; };
    if (!topology.isBoundary(i) && std::none_of(corners.begin(), corners.end(), joined))
    {
      const MeshTopology::Run ring = topology.ringVertices(i);
      mesh.addFace(std::vector<Index>(ring.begin(), ring.end()));
      std::for_each(corners.begin(), corners.end(), [&](Index corner) { joined(corner) = 1; });
    }
  }
  for (Index face = 0; face < triangles.faceCount(); ++face)
  {
    if (!isJoined[static_cast<std::size_t>(face)])
    {
      mesh.addFace({ triangles.faceVertex(face, 0), triangles.faceVertex(face, 1),
        triangles.faceVertex(face, 2) });
    }
  }
  return weldCoincidentPoints(mesh); // drops the points that were taken out
}

SurfaceMesh mixedSphere(int level)
{
  const SurfaceMesh mesh = withPolygons(icosphere(level), 2);
  const MeshTopology topology(mesh);
  std::vector<char> isJoined(static_cast<std::size_t>(mesh.faceCount()), 0);
  SurfaceMesh mixed;
  mixed.points = mesh.points;
  const auto isTriangle = [&](Index face)
  { return mesh.faceSize(face) == 3 && !isJoined[static_cast<std::size_t>(face)]; };
  for (Index corner = 0; corner < topology.cornerCount(); ++corner)
  {
    // Two triangles become a quad over the edge from vertex a to vertex b.
    const Index other = topology.opposite(corner);
    const Index face = topology.faceOf(corner);
    const Index neighbour = topology.faceOf(other);
    if (face % 3 == 0 && isTriangle(face) && isTriangle(neighbour))
    {
      mixed.addFace(
        { topology.vertexOf(topology.next(corner)), topology.vertexOf(topology.previous(corner)),
          topology.vertexOf(corner), topology.vertexOf(topology.previous(other)) });
      isJoined[static_cast<std::size_t>(face)] = 1;
      isJoined[static_cast<std::size_t>(neighbour)] = 1;
    }
  }
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    if (!isJoined[static_cast<std::size_t>(face)])
    {
      const auto begin =
        mesh.cornerVertices.begin() + mesh.faceOffsets[static_cast<std::size_t>(face)];
      mixed.addFace(std::vector<Index>(begin, begin + mesh.faceSize(face)));
    }
  }
  return mixed;
}

} // namespace evolving::shapes
