// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "VolumeFlows/VolumeFlux.h"

namespace evolving
{

void removeVolumeFlux(
  const SurfaceGeometry& geometry, const std::vector<char>& isHeld, std::vector<Vec3>& velocity)
{
  const std::vector<Index>& component = geometry.topology().componentOfVertex();
  std::vector<double> flux(at(geometry.topology().componentCount()), 0.0);
  std::vector<double> area(flux.size(), 0.0);
  for (std::size_t i = 0; i < velocity.size(); ++i)
  {
    if (!isHeld[i])
    {
      flux[at(component[i])] += geometry.coVolumes()[i] * velocity[i].dot(geometry.normals()[i]);
      area[at(component[i])] += geometry.coVolumes()[i];
    }
  }
  for (std::size_t i = 0; i < velocity.size(); ++i)
  {
    if (!isHeld[i])
    {
      velocity[i] -= flux[at(component[i])] / area[at(component[i])] * geometry.normals()[i];
    }
  }
}

} // namespace evolving
