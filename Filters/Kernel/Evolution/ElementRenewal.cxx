// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/ElementRenewal.h"

#include "Mesh/MeshQuality.h"
#include "Remeshing/CurvedReference.h"
#include "Remeshing/EdgeLengthLimits.h"
#include "Remeshing/IntersectionFreeStages.h"
#include "Remeshing/Relaxation.h"
#include "Remeshing/StarOptimization.h"

namespace evolving
{

namespace
{

/// Good elements stay between steps: none with a smaller angle, in degrees, and no more edges than
/// this part too short or too long.
constexpr double GoodAngle = 30.0;
constexpr double FewEdges = 0.01;
/// Passes between steps, which the next ones go on from, and where the flow ends.
constexpr int Passes = 2;
constexpr int LastPasses = 5;
constexpr int PolishPasses = 2;
/// At the end smallest angles up to this are worth a search, in degrees; and how many rounds of it.
constexpr double WantedAngle = 40.0;
constexpr int StarRounds = 3;

} // namespace

bool hasGoodElements(const EditableSurface& surface, const SurfaceMesh& mesh)
{
  Index edges = 0;
  Index badEdges = 0;
  for (Index e = 0; e < surface.edgeSlots(); ++e)
  {
    if (surface.isFirstHalf(e))
    {
      const double length = surface.length(e) / surface.size(surface.from(e), surface.to(e));
      badEdges += length < ShortestGoodPerSize || length > LongestGoodPerSize ? 1 : 0;
      ++edges;
    }
  }
  return badEdges <= FewEdges * edges && smallestAngle(mesh) >= GoodAngle;
}

void renewElements(EditableSurface& surface, const ReferenceSurface& reference,
  const ReferenceSurface* levels, const RemeshingOptions& options, bool isThorough,
  const Execution& execution)
{
  for (int pass = 0; pass < (isThorough ? LastPasses : Passes); ++pass)
  {
    remeshOnce(surface, reference, options, execution);
  }
  if (isThorough)
  {
    for (int pass = 0; pass < PolishPasses; ++pass)
    {
      polishOnce(surface, reference, options, execution);
    }
    if (levels)
    {
      land(surface, *levels, execution);
    }
    optimizeStars(surface, reference, WantedAngle, StarRounds, execution);
  }
}

SurfaceMesh withWorstAnglesMoved(const SurfaceMesh& surface, const Execution& execution)
{
  const Execution now = execution.phase(0.0, 0.0);
  const CurvedReference reference(surface, now);
  EditableSurface moved(surface);
  moveWithoutIntersections(
    moved, [&](EditableSurface& s) { optimizeStars(s, reference, GoodAngle, StarRounds, now); },
    now);
  return moved.mesh();
}

} // namespace evolving
