// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/Remeshing.h"

#include "Remeshing/EdgeFlipping.h"
#include "Remeshing/EdgeSplitting.h"
#include "Remeshing/Relaxation.h"

namespace evolving
{

void remeshOnce(EditableSurface& surface, const ReferenceSurface& reference,
  const RemeshingOptions& options, const Execution& execution)
{
  splitLongEdges(surface, options.longest);
  execution.report(0.2);
  collapseShortEdges(surface, options.shortest, options.guards);
  execution.report(0.4);
  flipForValences(surface);
  surface.compact();
  execution.report(0.5);
  relax(surface, reference, options.damping, options.relaxations, execution);
}

void polishOnce(EditableSurface& surface, const ReferenceSurface& reference,
  const RemeshingOptions& options, const Execution& execution)
{
  collapseLowValences(surface, options.guards);
  flipForValences(surface);
  surface.compact();
  execution.report(0.2);
  relax(surface, reference, options.damping, 2, execution);
  flipForAngles(surface);
  execution.report(0.6);
  relax(surface, reference, options.damping, 2, execution);
}

} // namespace evolving
