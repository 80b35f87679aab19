// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/LostTopologyRemedy.h"

#include "Remeshing/CoveringTriangles.h"
#include "ShrinkWrap/TightGrid.h"
#include "ShrinkWrap/WrapResolution.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

///@{
/// In a place that is to stay open. What is wider than an edge, or 1.6 cells, the start leaves open
/// (TargetTuning); half as many again give it a shape.
constexpr double EdgesAcross = 1.5;
constexpr double CellsAcross = 2.4;
///@}
/// Of the samples that an automatic grid has at most: a few gigabytes.
constexpr double MostToAskFor = 4.0;

/// Samples with cells of a size; none where there are as many, or cannot be.
std::optional<int> samplesFor(
  double cell, const WrapTarget& target, const ShrinkWrapOptions& options)
{
  if (target.cellSize() <= cell)
  {
    return std::nullopt;
  }
  const double volume = target.grid.spacing.prod() * static_cast<double>(target.grid.sampleCount());
  const double needed = volume / (cell * cell * cell);
  const auto automatic = static_cast<double>(mostSamples({}));
  if (needed > automatic)
  {
    const int samples = samplesForCells(target.box, target.offset, cell);
    return needed <= MostToAskFor * automatic ? std::optional<int>(samples) : std::nullopt;
  }
  const auto& asked = options.sampleDimensions;
  const bool isAsked = std::any_of(asked.begin(), asked.end(), [](int n) { return n > 0; });
  return isAsked ? std::optional<int>(0) : std::nullopt; // automatic ones follow the elements
}

/// Edges of a length, in the words of what was asked for.
void askForEdges(double edge, const LostTopology& lost, const ShrinkWrapOptions& options,
  LostTopologyRemedy& remedy)
{
  if (options.targetEdgeLength > 0.0)
  {
    remedy.edgeLength = edge;
    return;
  }
  const double points = std::ceil(coveringVertexCount(lost.area, edge));
  remedy.points = static_cast<Index>(std::min(points, double(MostPointsToAskFor)));
}

} // namespace

LostTopologyRemedy remedyFor(
  const LostTopology& lost, const WrapTarget& target, const ShrinkWrapOptions& options)
{
  LostTopologyRemedy remedy;
  remedy.isStart = options.start != WrapStart::Isosurface;
  remedy.isTooNarrow =
    lost.narrowest > 0.0 && lost.narrowest < LeastWidthToAskFor * target.edgeLength;
  if (remedy.isTooNarrow)
  {
    return remedy;
  }
  const double narrowest = lost.narrowest > 0.0 ? lost.narrowest : target.shortestEdge();
  remedy.samples = samplesFor(narrowest / CellsAcross, target, options);
  const double edge = narrowest / EdgesAcross;
  const bool isToBlame = edge < target.shortestEdge();
  if (isToBlame || !(remedy.isStart || remedy.samples))
  {
    askForEdges(isToBlame ? edge : target.shortestEdge() / EdgesAcross, lost, options, remedy);
  }
  return remedy;
}

} // namespace evolving
