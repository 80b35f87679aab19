// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/StarOptimization.h"

#include "Mesh/Angles.h"
#include "ParallelLoops.h"
#include "Remeshing/FaceShape.h"
#include "Remeshing/OrderedTasks.h"
#include "Remeshing/StarSearch.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace evolving
{

namespace
{

/// Stars that are worth a thread.
constexpr std::int64_t StarGrain = 16;

/// The vertices of triangles with an angle of a cosine above `limit`, the worst first.
std::vector<std::pair<double, Index>> verticesOfBadFaces(
  const EditableSurface& surface, double limit)
{
  std::vector<double> worst(at(surface.vertexSlots()), 0.0);
  for (Index f = 0; f < surface.faceSlots(); ++f)
  {
    if (surface.hasFace(f))
    {
      const double cosine = cosineOfSmallestAngle(surface, f);
      for (Index k = 0; k < 3 && cosine > limit; ++k)
      {
        double& w = worst[at(surface.from(3 * f + k))];
        w = std::max(w, cosine);
      }
    }
  }
  std::vector<std::pair<double, Index>> vertices;
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    if (worst[at(v)] > 0.0)
    {
      vertices.emplace_back(-worst[at(v)], v);
    }
  }
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

/// Vertices that are not neighbours have no edge in common.
std::vector<Index> edgesAt(const EditableSurface& surface, Index v)
{
  std::vector<Index> edges;
  surface.forEachOutgoing(v,
    [&](Index e)
    {
      for (const Index edge : { e, EditableSurface::previous(e) })
      {
        edges.push_back(surface.isFirstHalf(edge) ? edge : surface.opposite(edge));
      }
    });
  return edges;
}

/// Which stars a search has left as they are: it would do so again, until one of their vertices
/// moves.
class SettledStars
{
public:
  explicit SettledStars(const EditableSurface& surface)
    : Surface(surface)
    , Tried(at(surface.vertexSlots()), Never)
    , Moved(at(surface.vertexSlots()), Never)
  {
  }

  bool contain(Index v, int round) const
  {
    bool isSettled = this->Tried[at(v)] == round - 1 && this->Moved[at(v)] < round - 1;
    if (isSettled)
    {
      this->Surface.forEachNeighbour(
        v, [&](Index u) { isSettled = isSettled && this->Moved[at(u)] < round - 1; });
    }
    return isSettled;
  }

  void add(Index v, int round, bool hasMoved)
  {
    this->Tried[at(v)] = round;
    this->Moved[at(v)] = hasMoved ? round : this->Moved[at(v)];
  }

private:
  static constexpr int Never = -2;

  const EditableSurface& Surface;
  std::vector<int> Tried; ///< the last round in which a vertex was searched for a better place
  std::vector<int> Moved; ///< the last one in which it has found one
};

} // namespace

Index optimizeStarsOf(EditableSurface& surface, const ReferenceSurface& reference,
  const std::vector<Index>& vertices, double degrees, int rounds)
{
  const double limit = std::cos(degrees * RadiansPerDegree);
  StarSearch search(surface, reference);
  Index moves = 0;
  for (int round = 0; round < rounds; ++round)
  {
    Index moved = 0;
    for (const Index v : vertices)
    {
      moved += search.worstCosine(v) > limit && search.improve(v) ? 1 : 0;
    }
    moves += moved;
    if (moved == 0)
    {
      break;
    }
  }
  return moves;
}

Index optimizeStars(EditableSurface& surface, const ReferenceSurface& reference, double degrees,
  int rounds, const Execution& execution)
{
  const double limit = std::cos(degrees * RadiansPerDegree);
  SettledStars settled(surface);
  Index moves = 0;
  for (int round = 0; round < rounds; ++round)
  {
    execution.report(static_cast<double>(round) / rounds);
    const auto vertices = verticesOfBadFaces(surface, limit);
    std::vector<char> hasMoved(vertices.size(), 0);
    runInOrder(
      vertices.size(), [&](std::size_t i) { return edgesAt(surface, vertices[i].second); },
      surface.edgeSlots(), StarGrain,
      [&](std::size_t i)
      {
        const Index v = vertices[i].second;
        hasMoved[i] =
          !settled.contain(v, round) && StarSearch(surface, reference).improve(v) ? 1 : 0;
        settled.add(v, round, hasMoved[i] != 0);
      },
      execution);
    const auto moved = static_cast<Index>(std::count(hasMoved.begin(), hasMoved.end(), 1));
    moves += moved;
    if (moved == 0)
    {
      break;
    }
  }
  return moves;
}

} // namespace evolving
