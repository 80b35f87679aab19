// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/CreaseSizeChoice.h"

#include "Features/CapturableCreases.h"
#include "Features/CarriableFeatures.h"
#include "Features/TargetTriangles.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/Relaxation.h"
#include "Remeshing/SizingField.h"
#include "ShrinkWrap/WrapFeatures.h"

namespace evolving
{

namespace
{

/// Of the edges away from creases.
constexpr double SmallestPart = 0.125;
///@{
/// Between the shortest edges, and the longest ones, that are tried for a budget.
constexpr double TriedRatio = 1.4;
constexpr double TriedGrowth = 1.15;
///@}
/// Between samples of a crease, in edges away from it.
constexpr double SampleStep = 0.25;

SharpEdges capturable(const ShrinkWrapOptions& options, const WrapReference& reference,
  const TargetTriangles& target, const Execution& execution)
{
  const FeatureOptions features = wantedFeatures(options, reference, 0.0);
  OmittedCreases excluded;
  return capturableCreases(
    target, features, excludedTriangles(target, features), excluded, execution);
}

/// What elements with edges of a length can carry of them asks for sizes.
CreaseSizes sizesFor(const TargetTriangles& target, SharpEdges creases, double shortest,
  const PointBudget& budget, const Execution& execution)
{
  keepCarriable(target, creases, shortest, execution);
  CreaseSizing sizing;
  sizing.smallest = shortest;
  sizing.across = budget.across;
  sizing.largest = budget.longestEdge;
  sizing.step = SampleStep * budget.edgeLength;
  return CreaseSizes(target, creases, sizing, execution);
}

double expectedPoints(EditableSurface& surface, const CreaseSizes& sizes)
{
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    surface.setSize(v, sizes.at(surface.point(v)));
  }
  gradeSizes(surface, sizes.growth());
  return expectedVertices(surface);
}

} // namespace

std::shared_ptr<const CreaseSizes> chooseCreaseSizes(const ShrinkWrapOptions& options,
  const WrapReference& reference, const OuterRegion& region, const PointBudget& budget,
  const Execution& execution)
{
  const Execution now = execution.phase(0.0, 0.0);
  const TargetTriangles target(reference.visible(), now);
  const SharpEdges creases = capturable(options, reference, target, now);
  if (creases.list().empty())
  {
    return nullptr;
  }
  EditableSurface surface(region.boundary(now));
  if (budget.isLimit)
  {
    land(surface, reference, now);
  }
  for (double shortest = SmallestPart * budget.edgeLength; shortest < budget.edgeLength;
       shortest *= TriedRatio)
  {
    const CreaseSizes sizes = sizesFor(target, creases, shortest, budget, now);
    for (double edge = budget.edgeLength; edge <= budget.longestEdge; edge *= TriedGrowth)
    {
      const CreaseSizes tried = sizes.withLargest(edge);
      if (expectedPoints(surface, tried) <= budget.points)
      {
        return tried.smallest() < edge ? std::make_shared<const CreaseSizes>(tried) : nullptr;
      }
    }
  }
  return nullptr;
}

} // namespace evolving
