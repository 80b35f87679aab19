// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which probes belong to one place.
 */

#ifndef EVOLVING_PROBE_GROUPS_H
#define EVOLVING_PROBE_GROUPS_H

#include "LostTopology/MedialProbes.h"
#include "Mesh/MeshTopology.h"

#include <vector>

namespace evolving
{

/**
 * Those that begin as near to each other on the surface as places are, or across from each other:
 * of a hole all that begin on its wall, of a slit those of both its sides.
 * @param places from which they were made
 * @param topology of their surface, which is closed
 */
std::vector<std::vector<MedialProbe>> groupedProbes(
  const std::vector<MedialProbe>& probes, const ProbePlaces& places, const MeshTopology& topology);

} // namespace evolving

#endif
