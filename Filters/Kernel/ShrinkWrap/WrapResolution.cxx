// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapResolution.h"

#include "Mesh/TopologySummary.h"
#include "ShrinkWrap/CreaseSizeChoice.h"
#include "ShrinkWrap/TightGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace evolving
{

namespace
{

constexpr int FirstSamples = 128;
constexpr double MostPoints = 60000.0;
/// Of what is expected: the finish ends with some more or fewer.
constexpr double SurePart = 0.9;
/// Of the edges of a number of points that is asked for: beside creases it goes to smaller ones.
constexpr double LongestPart = 2.0;
///@{
/// Edges between two creases: about two, so that what an element cuts off a corner of a thin wall
/// stays on its side of the wall; fewer where points are counted.
constexpr double EnoughAcross = 1.8;
constexpr double FewAcross = 1.4;
///@}
/// Edges that differ by less are not worth a second look.
constexpr double Similar = 0.1;
/// From this on the start is as near as elements allow: TargetTuning::startPerEdge, startPerCell.
constexpr double CellsPerEdge = 1.6;
/// Of the shortest edges, where they are not alike: in a hole a few edges wide, or between two
/// walls, the start is else a crumple that no remeshing leaves.
constexpr double CellsPerShortestEdge = 2.4;
/// 800 MB.
constexpr double MostSamples = 32e6;
///@{
/// Where holes are missing cells are made smaller by this part, until so many are in an edge that
/// the elements are what closes the holes.
constexpr double FinerCells = 0.65;
constexpr double MostCellsPerEdge = 4.0;
///@}

/// With cells of a size, or the smallest allowed.
WrapResolution withCells(const ShrinkWrapOptions& options, WrapResolution resolution,
  const WrapTarget& target, double cell)
{
  const double least = std::cbrt(
    target.grid.spacing.prod() * static_cast<double>(target.grid.sampleCount()) / MostSamples);
  const int samples = samplesForCells(target.box, target.offset, std::max(cell, least));
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (options.sampleDimensions[axis] == 0)
    {
      resolution.samples[axis] = std::max(resolution.samples[axis], samples);
    }
  }
  return resolution;
}

/// Not around sheets, whose walls are as thick as large elements, nor where parts cross and hide
/// pieces of each other: there smaller elements run through each other, and are undone again.
bool wantsCreases(const ShrinkWrapOptions& options, const WrapReference& reference, bool isClean)
{
  return mayVarySizes(options) && reference.isOnTarget() &&
    (isClean || summarizeTopology(reference.visible()).isClosed());
}

void chooseEdges(const ShrinkWrapOptions& options, const WrapView& view, WrapResolution& needed,
  const Execution& execution, bool isClean)
{
  const WrapReference& reference = *view.reference();
  const double visible = surfaceArea(reference.visible());
  const int asked = options.targetNumberOfPoints;
  const double size = view.target()->modelSize();
  needed.edgeLength = asked > 0 ? edgeLengthFor(asked, visible + reference.sheetArea(), size)
                                : defaultEdgeLength(visible, size);
  if (!wantsCreases(options, reference, isClean))
  {
    return;
  }
  const bool isAsked = asked > 0;
  const PointBudget budget{ isAsked ? asked : SurePart * MostPoints, needed.edgeLength,
    (isAsked ? LongestPart : 1.0) * needed.edgeLength, isAsked ? FewAcross : EnoughAcross,
    !isAsked };
  needed.beside = chooseCreaseSizes(options, *view.reference(), view.region(), budget, execution);
  needed.edgeLength = needed.beside ? needed.beside->largest() : needed.edgeLength;
}

} // namespace

bool mayVarySizes(const ShrinkWrapOptions& options)
{
  return options.targetEdgeLength == 0.0 && !options.adaptToCurvature &&
    options.preserveFeatures != FeaturePreservation::Off;
}

WrapResolution firstResolution(const ShrinkWrapOptions& options)
{
  WrapResolution first;
  first.edgeLength = options.targetEdgeLength;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int asked = options.sampleDimensions[axis];
    first.samples[axis] = asked > 0 ? asked : FirstSamples;
  }
  return first;
}

GridIndex mostSamples(const ShrinkWrapOptions& options)
{
  const std::array<int, 3> first = firstResolution(options).samples;
  const GridIndex samples = GridIndex(first[0]) * first[1] * first[2];
  const auto& asked = options.sampleDimensions;
  const bool isAutomatic = std::find(asked.begin(), asked.end(), 0) != asked.end();
  return isAutomatic ? std::max(samples, static_cast<GridIndex>(MostSamples)) : samples;
}

std::optional<WrapResolution> neededResolution(
  const ShrinkWrapOptions& options, const WrapView& view, const Execution& execution, bool isClean)
{
  const WrapTarget& target = *view.target();
  const WrapResolution first = firstResolution(options);
  WrapResolution needed = first;
  if (options.targetEdgeLength == 0.0)
  {
    chooseEdges(options, view, needed, execution, isClean);
  }
  const double cell = needed.beside ? needed.beside->smallest() / CellsPerShortestEdge
                                    : needed.edgeLength / CellsPerEdge;
  needed = withCells(options, needed, target, cell);
  const double change = std::abs(needed.edgeLength - target.edgeLength);
  const bool isFineEnough =
    needed.samples == first.samples && !needed.beside && change <= Similar * target.edgeLength;
  return isFineEnough ? std::nullopt : std::optional<WrapResolution>(needed);
}

std::optional<WrapResolution> neededForPoints(
  const ShrinkWrapOptions& options, const WrapView& view)
{
  if (options.targetEdgeLength > 0.0 || options.targetNumberOfPoints == 0)
  {
    return std::nullopt;
  }
  WrapResolution needed = firstResolution(options);
  needed.edgeLength = edgeLengthFor(options.targetNumberOfPoints,
    surfaceArea(view.reference()->visible()), view.target()->modelSize());
  return needed;
}

std::optional<WrapResolution> finerResolution(
  const ShrinkWrapOptions& options, const WrapResolution& tried, const WrapView& view)
{
  const WrapTarget& target = *view.target();
  if (target.cellSize() * MostCellsPerEdge < target.shortestEdge())
  {
    return std::nullopt;
  }
  const WrapResolution finer = withCells(options, tried, target, FinerCells * target.cellSize());
  return finer.samples != tried.samples ? std::optional<WrapResolution>(finer) : std::nullopt;
}

} // namespace evolving
