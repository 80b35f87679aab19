// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapRemesher.h"

#include "ParallelLoops.h"
#include "Remeshing/EdgeCollapsing.h"
#include "Remeshing/EdgeFlipping.h"
#include "Remeshing/EdgeSplitting.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/IntersectionFreeStages.h"
#include "Remeshing/Remeshing.h"
#include "Remeshing/SizingField.h"
#include "Remeshing/VertexBudget.h"
#include "ShrinkWrap/FrontContacts.h"
#include "ShrinkWrap/WrapFinish.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace evolving
{

namespace
{

/// Far from the target elements grow with the distance.
void setSizesByDistance(
  EditableSurface& surface, const WrapTarget& target, const std::vector<double>& distance)
{
  const FlowTuning& tuning = target.tuning.flow;
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    const double size = target.elementSizeAt(surface.point(v));
    const double grown = size + tuning.farGrowth * (std::abs(distance[at(v)]) - size);
    surface.setSize(v, std::clamp(grown, size, tuning.farLargestSize * target.elementSize()));
  }
  gradeSizes(surface, tuning.farGradation);
}

} // namespace

WrapRemesher::WrapRemesher(std::shared_ptr<const WrapTarget> target,
  std::shared_ptr<const WrapReference> reference, const ShrinkWrapOptions& options)
  : Target(std::move(target))
  , Reference(std::move(reference))
  , Options(options)
{
}

std::optional<SurfaceMesh> WrapRemesher::remesh(
  const RemeshingInput& input, const Execution& execution)
{
  SurfaceMesh surface = input.surface;
  const double thickness = this->Target->tuning.flow.frontSizes * this->Target->elementSize();
  keepFrontsApart(surface, input.before, input.distance, thickness, execution.phase(0.0, 0.0));
  undoIntersections(surface, input.before, execution.phase(0.0, 0.0));
  surface = this->withRightSizes(surface, input.distance, execution.phase(0.0, 0.0));
  if (input.isLast)
  {
    FinishedWrap finished =
      finishWrap(surface, *this->Target, *this->Reference, this->Options, execution);
    this->Creases = finished.creases;
    this->Adaptation = finished.adaptation;
    return std::move(finished.surface);
  }
  return surface;
}

SurfaceMesh WrapRemesher::withRightSizes(
  const SurfaceMesh& surface, const std::vector<double>& distance, const Execution& execution) const
{
  EditableSurface editable(surface);
  setSizesByDistance(editable, *this->Target, distance);
  requireFewVertices(editable, this->Target->edgeLength);
  const RemeshingOptions options;
  runWithoutIntersections(
    editable,
    [&options](EditableSurface& s)
    {
      splitLongEdges(s, options.longest);
      collapseShortEdges(s, options.shortest, options.guards);
      flipForValences(s);
      s.compact();
    },
    execution);
  return editable.mesh();
}

} // namespace evolving
