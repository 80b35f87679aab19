// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/Remeshing.h"

#include "Errors.h"
#include "Remeshing/EdgeFlipping.h"
#include "Remeshing/EdgeSplitting.h"
#include "Remeshing/Relaxation.h"

#include <sstream>

namespace evolving
{

namespace
{

/// More halve an edge a million times as long as it should be.
constexpr int MostSweeps = 20;
void requireFew(const EditableSurface& surface, double most)
{
  const Index vertices = surface.vertexSlots();
  if (vertices > most)
  {
    std::ostringstream message;
    message << "Splitting long edges made " << vertices << " vertices, expected at most " << most
            << "; set a larger TargetEdgeLength, or repair faces that are long and thin.";
    throw InputError(message.str());
  }
}

/// A needle that is halved at both of its long sides has a third long edge, across: one that is a
/// thousand times as long as edges should be becomes a hundred thousand before they collapse.
void splitToSize(EditableSurface& surface, const RemeshingOptions& options)
{
  for (int sweep = 0; sweep < MostSweeps && halveLongEdges(surface, options.longest) > 0; ++sweep)
  {
    requireFew(surface, options.mostVertices);
  }
}

} // namespace

void remeshOnce(EditableSurface& surface, const ReferenceSurface& reference,
  const RemeshingOptions& options, const Execution& execution)
{
  splitToSize(surface, options);
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
