// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Velocities that move no volume.
 */

#ifndef EVOLVING_VOLUME_FLUX_H
#define EVOLVING_VOLUME_FLUX_H

#include "Operators/SurfaceGeometry.h"

#include <vector>

namespace evolving
{

/**
 * Subtracts the mean normal speed of every connected component: -H becomes mean H - H. So the
 * velocities are those that multipliers of the volume lead to, as far as a step is short.
 * @param isHeld vertices that rest, and do not count
 * @param[in,out] velocity one per vertex
 */
void removeVolumeFlux(
  const SurfaceGeometry& geometry, const std::vector<char>& isHeld, std::vector<Vec3>& velocity);

} // namespace evolving

#endif
