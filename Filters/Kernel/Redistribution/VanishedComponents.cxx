// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/VanishedComponents.h"

#include "ParallelLoops.h"

#include <algorithm>

namespace evolving
{

VanishedComponents::VanishedComponents(
  const SurfaceMesh& start, const MeshTopology& topology, double smallestArea)
  : Topology(topology)
  , StartArea(this->areas(start))
  , IsVanished(at(topology.componentCount() > 1 ? topology.componentCount() : 0), 0)
{
  for (double& area : this->StartArea)
  {
    area = std::max(area, smallestArea);
  }
}

double VanishedComponents::smallestStartArea() const
{
  const auto smallest = std::min_element(this->StartArea.begin(), this->StartArea.end());
  return smallest == this->StartArea.end() ? 0.0 : *smallest;
}

std::vector<double> VanishedComponents::areas(const SurfaceMesh& mesh) const
{
  std::vector<double> areas(at(this->Topology.componentCount()), 0.0);
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    const Index component = this->Topology.componentOfVertex()[at(mesh.faceVertex(face, 0))];
    areas[at(component)] += faceVectorArea(mesh, face).norm();
  }
  return areas;
}

void VanishedComponents::update(const SurfaceMesh& mesh)
{
  if (this->IsVanished.empty())
  {
    return;
  }
  const std::vector<double> areas = this->areas(mesh);
  for (std::size_t c = 0; c < areas.size(); ++c)
  {
    this->IsVanished[c] = areas[c] < SmallestAreaPart * this->StartArea[c];
  }
}

bool VanishedComponents::contain(Index vertex) const
{
  const Index component = this->Topology.componentOfVertex()[at(vertex)];
  return !this->IsVanished.empty() && component != NoIndex && this->IsVanished[at(component)];
}

} // namespace evolving
