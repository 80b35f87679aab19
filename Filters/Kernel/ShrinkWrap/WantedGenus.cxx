// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WantedGenus.h"

#include "Mesh/SelfIntersections.h"
#include "Mesh/TopologySummary.h"

namespace evolving
{

bool keepsTopology(const ShrinkWrapOptions& options)
{
  return options.gapSize == 0.0 && options.offsetDistance == 0.0;
}

std::optional<Index> genusToKeep(
  const SurfaceMesh& target, const ShrinkWrapOptions& options, const Execution& execution)
{
  if (!keepsTopology(options))
  {
    return std::nullopt;
  }
  const TopologySummary topology = summarizeTopology(target);
  const bool isOneSurface = topology.isClosed() && topology.isManifold() && topology.isOriented() &&
    topology.components == 1;
  const bool isClean = isOneSurface && selfIntersections(triangleView(target), execution).empty();
  return isClean ? std::optional<Index>(topology.genus()) : std::nullopt;
}

} // namespace evolving
