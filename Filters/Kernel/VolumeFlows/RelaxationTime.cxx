// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "VolumeFlows/RelaxationTime.h"

#include "Mesh/Angles.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace evolving
{

namespace
{

/// What is left of the difference, as with a distance field: no eye sees it.
constexpr double DifferenceLeft = 1e-3;

/// r^2 of the component with the largest area.
double largestSquaredRadius(const SurfaceMesh& surface)
{
  const MeshTopology topology(surface);
  std::vector<double> areas(at(topology.componentCount()), 0.0);
  for (Index face = 0; face < surface.faceCount(); ++face)
  {
    const Index component = topology.componentOfVertex()[at(surface.faceVertex(face, 0))];
    areas[at(component)] += faceVectorArea(surface, face).norm();
  }
  return *std::max_element(areas.begin(), areas.end()) / (4.0 * Pi);
}

} // namespace

double relaxationTimeOfCurvatureFlow(const SurfaceMesh& surface)
{
  return -std::log(DifferenceLeft) / 4.0 * largestSquaredRadius(surface);
}

double relaxationTimeOfDiffusion(const SurfaceMesh& surface)
{
  const double squaredRadius = largestSquaredRadius(surface);
  return -std::log(DifferenceLeft) / 24.0 * squaredRadius * squaredRadius;
}

} // namespace evolving
