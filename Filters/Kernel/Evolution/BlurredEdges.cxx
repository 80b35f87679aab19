// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/BlurredEdges.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// The mean of H over each component.
std::vector<double> meanCurvatures(const SurfaceGeometry& geometry)
{
  const MeshTopology& topology = geometry.topology();
  std::vector<double> integral(at(topology.componentCount()), 0.0);
  std::vector<double> area(at(topology.componentCount()), 0.0);
  for (std::size_t v = 0; v < geometry.coVolumes().size(); ++v)
  {
    const Index component = topology.componentOfVertex()[v];
    if (component != NoIndex)
    {
      const double share = geometry.coVolumes()[v];
      integral[at(component)] += share * geometry.meanCurvature(static_cast<Index>(v));
      area[at(component)] += share;
    }
  }
  for (std::size_t c = 0; c < area.size(); ++c)
  {
    integral[c] = area[c] > 0.0 ? integral[c] / area[c] : 0.0;
  }
  return integral;
}

} // namespace

std::vector<Vec3> onBlurredEdges(
  const SurfaceMesh& mesh, const SurfaceGeometry& geometry, double blur)
{
  std::vector<Vec3> points = mesh.points;
  if (blur == 0.0)
  {
    return points;
  }
  const double most = std::sqrt(blur);
  std::vector<double> shifts = meanCurvatures(geometry);
  for (double& shift : shifts)
  {
    shift = std::clamp(0.5 * blur * shift, -most, most);
  }
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    const Index component = geometry.topology().componentOfVertex()[v];
    if (component != NoIndex)
    {
      points[v] -= shifts[at(component)] * geometry.normals()[v];
    }
  }
  return points;
}

} // namespace evolving
