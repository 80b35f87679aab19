// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapLooks.h"

#include "Crossings/OuterSurface.h"
#include "Mesh/SeamWelding.h"
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

/// What is seen of parts that run through each other; none where nothing does.
std::optional<SurfaceMesh> unionOf(const SurfaceMesh& mesh, const Execution& execution)
{
  return mesh.faceCount() > 0
    ? outerSurface(weldSeams(weldCoincidentPoints(mesh), roundingOf(mesh)), execution)
    : std::nullopt;
}

} // namespace

SeenTarget lookAsNeeded(const SurfaceMesh& mesh, const ShrinkWrapOptions& options,
  const WrapTuning& tuning, const Execution& execution)
{
  checkOptions(options);
  validate(mesh);
  const std::optional<SurfaceMesh> united = unionOf(mesh, execution.phase(0.0, 0.1));
  const bool isClosedUnion = united && summarizeTopology(*united).isClosed();
  SeenTarget seen;
  WrapResolution tried;
  const auto look = [&](const WrapResolution& resolution, const Execution& now)
  {
    tried = resolution;
    seen.view.reset(); // before the grids of the next one need its memory
    seen.view =
      std::make_unique<WrapView>(united ? *united : mesh, options, resolution, tuning, now);
  };
  look(firstResolution(options), execution.phase(0.1, 0.5));
  const Execution now = execution.phase(0.5, 0.5);
  std::optional<WrapResolution> next;
  if (mesh.faceCount() == 0)
  {
    next = neededForPoints(options, *seen.view);
  }
  else
  {
    if (!united)
    {
      seen.wantedGenus = genusToKeep(seen.view->target()->surface, options, now);
    }
    const bool isClean = isClosedUnion || seen.wantedGenus.has_value();
    next = neededResolution(options, *seen.view, now, isClean);
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
