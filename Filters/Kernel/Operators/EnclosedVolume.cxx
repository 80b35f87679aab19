// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Operators/EnclosedVolume.h"

namespace evolving
{

namespace
{

/// What the volume of every component is measured from. Elements may change between the volumes of
/// an open one: the box around its boundary does not, which keeps its shape.
std::vector<Vec3> centersOf(const SurfaceMesh& mesh, const MeshTopology& topology)
{
  std::vector<Box> boundaries(at(topology.componentCount()));
  std::vector<Vec3> centers(boundaries.size());
  for (Index i = mesh.vertexCount() - 1; i >= 0; --i)
  {
    const Index component = topology.componentOfVertex()[at(i)];
    if (component != NoIndex)
    {
      centers[at(component)] = mesh.points[at(i)];
    }
    if (topology.isBoundary(i))
    {
      boundaries[at(component)].extend(mesh.points[at(i)]);
    }
  }
  for (std::size_t c = 0; c < centers.size(); ++c)
  {
    centers[c] = boundaries[c].isEmpty() ? centers[c] : Vec3(boundaries[c].center());
  }
  return centers;
}

} // namespace

std::vector<double> componentVolumes(const SurfaceMesh& mesh, const MeshTopology& topology)
{
  const std::vector<Vec3> centers = centersOf(mesh, topology);
  std::vector<double> volumes(centers.size(), 0.0);
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    const Index component = topology.componentOfVertex()[at(mesh.faceVertex(face, 0))];
    volumes[at(component)] +=
      faceVectorArea(mesh, face).dot(mesh.facePoint(face, 0) - centers[at(component)]) / 3.0;
  }
  return volumes;
}

std::vector<Vec3> volumeGradient(const SurfaceMesh& mesh)
{
  std::vector<Vec3> gradient(mesh.points.size(), Vec3::Zero());
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    const Vec3& first = mesh.facePoint(face, 0);
    for (Index k = 1; k + 1 < mesh.faceSize(face); ++k)
    {
      const Vec3 third =
        (mesh.facePoint(face, k) - first).cross(mesh.facePoint(face, k + 1) - first) / 6.0;
      gradient[at(mesh.faceVertex(face, 0))] += third;
      gradient[at(mesh.faceVertex(face, k))] += third;
      gradient[at(mesh.faceVertex(face, k + 1))] += third;
    }
  }
  return gradient;
}

} // namespace evolving
