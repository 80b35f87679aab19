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
#include <cstdint>
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

  bool contain(Index v) const
  {
    const std::int64_t tried = this->Tried[at(v)];
    bool isSettled = tried != Never && this->Moved[at(v)] < tried;
    if (isSettled)
    {
      this->Surface.forEachNeighbour(
        v, [&](Index u) { isSettled = isSettled && this->Moved[at(u)] < tried; });
    }
    return isSettled;
  }

  /// @param time larger for later searches of this star and those around it
  void add(Index v, std::int64_t time, bool hasMoved)
  {
    this->Tried[at(v)] = time;
    this->Moved[at(v)] = hasMoved ? time : this->Moved[at(v)];
  }

private:
  static constexpr std::int64_t Never = -1;

  const EditableSurface& Surface;
  std::vector<std::int64_t> Tried; ///< when a vertex was last searched for a better place
  std::vector<std::int64_t> Moved; ///< when it has last found one
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
      moved += cosineOfSmallestAngleAround(surface, v) > limit && search.improve(v) ? 1 : 0;
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
    const std::int64_t time = std::int64_t(round) * surface.vertexSlots();
    runInOrder(
      vertices.size(), [&](std::size_t i) { return edgesAt(surface, vertices[i].second); },
      surface.edgeSlots(), StarGrain,
      [&](std::size_t i)
      {
        const Index v = vertices[i].second;
        if (!settled.contain(v))
        {
          hasMoved[i] = StarSearch(surface, reference).improve(v) ? 1 : 0;
          settled.add(v, time + static_cast<std::int64_t>(i), hasMoved[i] != 0);
        }
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
