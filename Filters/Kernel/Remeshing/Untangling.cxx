// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/Untangling.h"

#include "Mesh/SelfIntersections.h"

#include <cstddef>
#include <set>

namespace evolving
{

namespace
{

/// A fold of one element is gone after the first; where some do not help, more would only smooth.
constexpr int MostRounds = 3;
/// More are no small place: smoothing would wear walls away.
constexpr std::size_t MostPairs = 32;

std::set<Index> verticesOf(
  const EditableSurface& surface, const std::vector<std::pair<Index, Index>>& pairs)
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

Vec3 middleOfNeighbours(const EditableSurface& surface, Index v)
{
  Vec3 sum = Vec3::Zero();
  double count = 0.0;
  surface.forEachNeighbour(v,
    [&](Index u)
    {
      sum += surface.point(u);
      count += 1.0;
    });
  return sum / count;
}

} // namespace

bool untangle(
  EditableSurface& surface, std::vector<std::pair<Index, Index>> pairs, const Execution& execution)
{
  for (int round = 0; round < MostRounds && !pairs.empty() && pairs.size() <= MostPairs; ++round)
  {
    for (const Index v : verticesOf(surface, pairs))
    {
      if (!surface.isPinned(v) && surface.featureEdges(v) == 0)
      {
        surface.setPoint(v, middleOfNeighbours(surface, v));
      }
    }
    pairs = selfIntersections(surface.triangles(), execution.phase(0.0, 0.0));
  }
  return pairs.empty();
}

} // namespace evolving
