// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LostTopology/LostTopology.h"

#include "LostTopology/OuterParts.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/TopologySummary.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

namespace evolving
{

namespace
{

/// Of a part, in diagonals of its box: about that of a bar three times as long; a cube has 0.58.
constexpr double ThicknessOfParts = 0.3;

bool hasGenus(const TopologySummary& topology)
{
  return topology.faces > 0 && topology.isClosed() && topology.isManifold() &&
    topology.isOriented();
}

/// The smallest width of the widest places that count, if one could ask for elements so small.
double narrowestOf(const std::vector<ChangedPlace>& places, Index count, double least)
{
  for (std::size_t i = std::min(places.size(), at(count)); i > 1; --i)
  {
    if (places[i - 1].width >= least)
    {
      return places[i - 1].width;
    }
  }
  return places.empty() ? HUGE_VAL : places.front().width;
}

/// At least one.
Index changesOf(const LostTopology& lost)
{
  return std::abs(lost.genus - lost.genusOfResult) + std::abs(lost.parts - lost.partsOfResult);
}

/// Drops what says nothing new, and finds how narrow a place has been too narrow.
void weigh(LostTopology& lost, double edgeLength)
{
  ChangedPlaces& places = lost.places;
  const Index changes = changesOf(lost);
  if (places.filled.size() + places.missingParts.size() >= at(changes))
  {
    places.missing.clear(); // sharp edges that are rounder now look like thin walls
  }
  const double least = LeastWidthToAskFor * edgeLength;
  const double narrowest = std::min(
    { narrowestOf(places.filled, changes, least), narrowestOf(places.missing, changes, least),
      ThicknessOfParts * narrowestOf(places.missingParts, changes, least) });
  lost.narrowest = std::isfinite(narrowest) ? narrowest : 0.0;
}

bool isLike(const TopologySummary& a, const TopologySummary& b)
{
  return a.genus() == b.genus() && a.components == b.components;
}

} // namespace

std::optional<LostTopology> findLostTopology(const SurfaceMesh& target, const SurfaceMesh& result,
  double edgeLength, const Execution& execution)
{
  const TopologySummary ofResult = summarizeTopology(result);
  const TopologySummary ofTarget = summarizeTopology(target);
  const bool isKnown = hasGenus(ofResult) && hasGenus(ofTarget);
  if (!isKnown || (ofTarget.components == 1 && isLike(ofResult, ofTarget)))
  {
    return std::nullopt;
  }
  const SurfaceMesh seen = outerParts(target, execution.phase(0.0, 0.2));
  const TopologySummary wanted = summarizeTopology(seen);
  // Intersections last: they take longest, and most results have lost nothing.
  if (isLike(ofResult, wanted) ||
    !selfIntersections(triangleView(target), execution.phase(0.2, 0.4)).empty())
  {
    return std::nullopt;
  }
  LostTopology lost;
  lost.genus = wanted.genus();
  lost.parts = wanted.components;
  lost.genusOfResult = ofResult.genus();
  lost.partsOfResult = ofResult.components;
  lost.area = surfaceArea(seen);
  const bool mayLackParts = lost.partsOfResult < lost.parts;
  const std::size_t enoughFilled =
    mayLackParts ? std::numeric_limits<std::size_t>::max() : at(changesOf(lost));
  lost.places =
    findChangedPlaces(seen, result, edgeLength, enoughFilled, execution.phase(0.4, 1.0));
  weigh(lost, edgeLength);
  return lost;
}

} // namespace evolving
