// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/Untangling.h"

#include "Mesh/DisjointSets.h"
#include "Mesh/SelfIntersections.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace evolving
{

namespace
{

/// A fold of one element is gone after the first; where some do not help, more would only smooth.
constexpr int SmoothingRounds = 3;
/// What creases hold is smoothed with all around it, and that so often.
constexpr int ReleasingRounds = 5;
/// More are no small place: smoothing would wear walls away.
constexpr Index MostPairs = 32;

/// Of some pairs those in places of few: pairs whose triangles share vertices are in one place.
FacePairs inSmallPlaces(const EditableSurface& surface, const FacePairs& pairs)
{
  DisjointSets places(at(surface.vertexSlots()));
  for (const auto& [first, second] : pairs)
  {
    for (Index k = 0; k < 3; ++k)
    {
      places.join(surface.from(3 * first), surface.from(3 * first + k));
      places.join(surface.from(3 * first), surface.from(3 * second + k));
    }
  }
  std::vector<Index> count(at(surface.vertexSlots()), 0);
  const auto placeOf = [&](const FacePair& pair)
  { return at(places.find(surface.from(3 * pair.first))); };
  for (const FacePair& pair : pairs)
  {
    ++count[placeOf(pair)];
  }
  FacePairs small;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(small),
    [&](const FacePair& pair) { return count[placeOf(pair)] <= MostPairs; });
  return small;
}

std::set<Index> verticesOf(const EditableSurface& surface, const FacePairs& pairs)
{
  std::set<Index> vertices;
  for (const auto& [first, second] : pairs)
  {
    for (Index k = 0; k < 3; ++k)
    {
      vertices.insert(surface.from(3 * first + k));
      vertices.insert(surface.from(3 * second + k));
    }
  }
  return vertices;
}

std::set<Index> withNeighbours(const EditableSurface& surface, const std::set<Index>& vertices)
{
  std::set<Index> more = vertices;
  for (const Index v : vertices)
  {
    surface.forEachNeighbour(v, [&](Index u) { more.insert(u); });
  }
  return more;
}

/// Locked vertices, and pinned ones beside no crease, stay held.
void releaseCreases(EditableSurface& surface, const std::set<Index>& vertices)
{
  for (const Index v : vertices)
  {
    if (surface.featureEdges(v) > 0 && !surface.isLocked(v))
    {
      surface.releasePin(v);
      surface.forEachOutgoing(v,
        [&](Index e)
        {
          surface.setCurve(e, NoIndex);
          surface.setLabel(EditableSurface::faceOf(e), NoIndex);
        });
    }
  }
}

} // namespace

FacePairs untangle(EditableSurface& surface, FacePairs pairs, const Execution& execution)
{
  for (int round = 0; round < SmoothingRounds + ReleasingRounds; ++round)
  {
    const FacePairs small = inSmallPlaces(surface, pairs);
    if (small.empty())
    {
      break;
    }
    std::set<Index> vertices = verticesOf(surface, small);
    if (round >= SmoothingRounds)
    {
      vertices = withNeighbours(surface, vertices);
      releaseCreases(surface, vertices);
    }
    for (const Index v : vertices)
    {
      if (!surface.isPinned(v) && surface.featureEdges(v) == 0)
      {
        surface.setPoint(v, surface.middleOfNeighbours(v));
      }
    }
    pairs = selfIntersections(surface.triangles(), execution.phase(0.0, 0.0));
  }
  return pairs;
}

} // namespace evolving
