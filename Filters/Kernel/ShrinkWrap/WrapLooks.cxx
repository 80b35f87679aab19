// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapLooks.h"

#include "Mesh/TopologySummary.h"
#include "ShrinkWrap/WantedGenus.h"
#include "ShrinkWrap/WrapResolution.h"

namespace evolving
{

namespace
{

/// Are the holes and handles of the target those of the start?
bool showsGenus(const WrapView& view, std::optional<Index> wanted)
{
  if (!wanted)
  {
    return true;
  }
  const TopologySummary topology = summarizeTopology(view.region().boundary());
  return topology.components == 1 && topology.genus() == *wanted;
}

} // namespace

SeenTarget lookAsNeeded(const SurfaceMesh& mesh, const ShrinkWrapOptions& options,
  const WrapTuning& tuning, const Execution& execution)
{
  SeenTarget seen;
  WrapResolution tried;
  const auto look = [&](const WrapResolution& resolution, const Execution& now)
  {
    tried = resolution;
    seen.view.reset(); // before the grids of the next one need its memory
    seen.view = std::make_unique<WrapView>(mesh, options, resolution, tuning, now);
  };
  look(firstResolution(options), execution.phase(0.0, 0.5));
  const Execution now = execution.phase(0.5, 0.5);
  std::optional<WrapResolution> next;
  if (mesh.faceCount() == 0)
  {
    next = neededForPoints(options, *seen.view);
  }
  else
  {
    seen.wantedGenus = genusToKeep(seen.view->target()->surface, options, now);
    next = neededResolution(options, *seen.view, now, seen.wantedGenus.has_value());
  }
  if (next)
  {
    look(*next, execution.phase(0.5, 1.0));
  }
  while (!showsGenus(*seen.view, seen.wantedGenus) &&
    (next = finerResolution(options, tried, *seen.view)))
  {
    look(*next, execution.phase(1.0, 1.0));
  }
  return seen;
}

} // namespace evolving
