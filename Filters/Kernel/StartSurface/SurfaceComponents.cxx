// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/SurfaceComponents.h"

#include "Mesh/MeshTopology.h"

#include <algorithm>

namespace evolving
{

namespace
{

/// A mesh's components, and whose each face is.
struct Partition
{
  std::vector<SurfaceComponent> components;
  std::vector<Index> ofFace;
};

/// Adds the signed volume of a face's cone from the component's centre, by a fan of tetrahedra.
void addFaceMeasures(const SurfaceMesh& mesh, Index face, SurfaceComponent& component)
{
  const Vec3 centre = component.box.center();
  const Vec3 vectorArea = faceVectorArea(mesh, face);
  component.area += vectorArea.norm();
  component.faces += 1;
  const Vec3 base = mesh.facePoint(face, 0) - centre;
  for (Index k = 1; k + 1 < mesh.faceSize(face); ++k)
  {
    const Vec3 second = mesh.facePoint(face, k) - centre;
    const Vec3 third = mesh.facePoint(face, k + 1) - centre;
    component.volume += base.dot(second.cross(third)) / 6.0;
  }
}

Partition partition(const SurfaceMesh& mesh)
{
  const MeshTopology topology(mesh);
  const std::vector<Index>& ofVertex = topology.componentOfVertex();
  Partition result;
  result.components.resize(at(topology.componentCount()));
  for (std::size_t v = 0; v < ofVertex.size(); ++v)
  {
    if (ofVertex[v] != NoIndex)
    {
      result.components[at(ofVertex[v])].box.extend(mesh.points[v]);
    }
  }
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    result.ofFace.push_back(ofVertex[at(mesh.faceVertex(face, 0))]);
    addFaceMeasures(mesh, face, result.components[at(result.ofFace.back())]);
  }
  return result;
}

/// The faces whose component is kept, and the points they use, in their old order.
SurfaceMesh keepFaces(
  const SurfaceMesh& mesh, const std::vector<Index>& ofFace, const std::vector<char>& keep)
{
  std::vector<Index> number(mesh.points.size(), NoIndex);
  SurfaceMesh kept;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    if (keep[at(ofFace[at(face)])])
    {
      std::vector<Index> vertices;
      for (Index k = 0; k < mesh.faceSize(face); ++k)
      {
        vertices.push_back(mesh.faceVertex(face, k));
        number[at(vertices.back())] = 0;
      }
      kept.addFace(vertices);
    }
  }
  for (std::size_t v = 0; v < number.size(); ++v)
  {
    number[v] = number[v] == NoIndex ? NoIndex : kept.addPoint(mesh.points[v]);
  }
  for (Index& vertex : kept.cornerVertices)
  {
    vertex = number[at(vertex)];
  }
  return kept;
}

template <typename Predicate>
SurfaceMesh keepWhere(const SurfaceMesh& mesh, const Predicate& isKept)
{
  const Partition parts = partition(mesh);
  std::vector<char> keep;
  for (const SurfaceComponent& component : parts.components)
  {
    keep.push_back(isKept(component) ? 1 : 0);
  }
  return keepFaces(mesh, parts.ofFace, keep);
}

} // namespace

std::vector<SurfaceComponent> surfaceComponents(const SurfaceMesh& mesh)
{
  return partition(mesh).components;
}

SurfaceMesh keepLargestComponent(const SurfaceMesh& mesh)
{
  const Partition parts = partition(mesh);
  const auto largest = std::max_element(parts.components.begin(), parts.components.end(),
    [](const SurfaceComponent& a, const SurfaceComponent& b) { return a.area < b.area; });
  std::vector<char> keep(parts.components.size(), 0);
  if (!keep.empty())
  {
    keep[static_cast<std::size_t>(largest - parts.components.begin())] = 1;
  }
  return keepFaces(mesh, parts.ofFace, keep);
}

SurfaceMesh dropSmallComponents(const SurfaceMesh& mesh, double shortestDiagonal)
{
  return keepWhere(mesh,
    [shortestDiagonal](const SurfaceComponent& component)
    { return component.box.diagonal().norm() >= shortestDiagonal; });
}

SurfaceMesh dropCavityWalls(const SurfaceMesh& mesh)
{
  return keepWhere(mesh, [](const SurfaceComponent& component) { return component.volume >= 0.0; });
}

} // namespace evolving
