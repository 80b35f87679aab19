// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/AdvectionLimit.h"

#include "ParallelLoops.h"

#include <algorithm>

namespace evolving
{

void limitByEdges(const SurfaceMesh& mesh, const MeshTopology& topology, double longest,
  double timeStep, std::vector<double>& speed, const Execution& execution)
{
  if (longest == 0.0)
  {
    return;
  }
  forEachIndex(execution, mesh.vertexCount(),
    [&](Index i)
    {
      const MeshTopology::Run ring = topology.ringVertices(i);
      double lengths = 0.0;
      for (const Index j : ring)
      {
        lengths += (mesh.points[at(j)] - mesh.points[at(i)]).norm();
      }
      const double fastest = longest * lengths / std::max(1, ring.size()) / timeStep;
      speed[at(i)] = std::clamp(speed[at(i)], -fastest, fastest);
    });
}

} // namespace evolving
