// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/StarOptimization.h"

#include "Mesh/Angles.h"
#include "Mesh/Orthogonal.h"
#include "ParallelLoops.h"
#include "Remeshing/FaceShape.h"
#include "Remeshing/OrderedTasks.h"
#include "Remeshing/Relaxation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace evolving
{

namespace
{

constexpr double Diagonal = 0.70710678118654752440;
/// In the tangent plane, counter-clockwise.
const std::array<Eigen::Vector2d, 8> Directions = { { { 1.0, 0.0 }, { Diagonal, Diagonal },
  { 0.0, 1.0 }, { -Diagonal, Diagonal }, { -1.0, 0.0 }, { -Diagonal, -Diagonal }, { 0.0, -1.0 },
  { Diagonal, -Diagonal } } };
/// The search begins with moves of this fraction of the size and halves them so often.
constexpr double FirstMove = 0.15;
constexpr int Halvings = 6;
/// No face may turn by more than 45 degrees in a move.
constexpr double LeastCosine = 0.7;
/// Stars that are worth a thread.
constexpr std::int64_t StarGrain = 16;
/// The cosine must fall by this much, or rounding would go on for ever.
constexpr double LeastGain = 1e-7;

class StarSearch
{
public:
  StarSearch(EditableSurface& surface, const ReferenceSurface& reference)
    : Surface(surface)
    , Reference(reference)
  {
  }

  /// @return whether the vertex has moved
  bool improve(Index v)
  {
    this->Curve = curveOfVertex(this->Surface, v);
    const bool isInner = this->Surface.featureEdges(v) == 0;
    if (this->Surface.isPinned(v) || (!isInner && this->Curve == NoIndex))
    {
      return false;
    }
    this->begin(v);
    bool hasMoved = false;
    double move = FirstMove * this->Surface.size(v);
    for (int halving = 0; halving < Halvings; move *= 0.5, ++halving)
    {
      hasMoved = this->searchAt(v, move) || hasMoved;
    }
    return hasMoved;
  }

  double worstCosine(Index v) const
  {
    double worst = 0.0;
    this->Surface.forEachOutgoing(v,
      [&](Index e)
      {
        worst = std::max(worst,
          cosineOfSmallestAngle(this->Surface.point(v), this->Surface.point(this->Surface.to(e)),
            this->Surface.point(this->Surface.apex(e))));
      });
    return worst;
  }

private:
  void begin(Index v)
  {
    const Vec3 normal = this->Surface.normal(v);
    this->U = orthogonalTo(normal).normalized();
    this->V = normal.cross(this->U);
    this->Normal = normal;
    this->Label = 0;
    this->OldAreas.clear();
    this->Surface.forEachOutgoing(v,
      [&](Index e)
      {
        this->Label = this->Surface.label(EditableSurface::faceOf(e));
        this->OldAreas.push_back(this->Surface.doubleArea(EditableSurface::faceOf(e)));
      });
    this->Worst = this->worstCosine(v);
    const ReferenceSurface::Foot foot = this->foot(this->Surface.point(v), this->Surface.guess(v));
    this->Height =
      this->Curve == NoIndex ? (this->Surface.point(v) - foot.point).dot(foot.normal) : 0.0;
  }

  ReferenceSurface::Foot foot(const Vec3& point, Index guess) const
  {
    return this->Reference.onSurface(point, this->Normal, this->Label, guess);
  }

  /// Tries all directions at one distance, as long as one helps.
  bool searchAt(Index v, double move)
  {
    bool hasMoved = false;
    for (bool goesOn = true; goesOn;)
    {
      goesOn = false;
      for (const Eigen::Vector2d& direction : Directions)
      {
        if (this->tryMove(v, move * (direction.x() * this->U + direction.y() * this->V)))
        {
          goesOn = true;
          hasMoved = true;
        }
      }
    }
    return hasMoved;
  }

  bool tryMove(Index v, const Vec3& move)
  {
    const Vec3 before = this->Surface.point(v);
    const Index guess = this->Surface.guess(v);
    // Most tries fail already in the tangent plane: the search for the foot is what costs.
    this->Surface.setPoint(v, before + move);
    if (this->worstCosine(v) < this->Worst)
    {
      this->place(v, before + move);
      const double worst = this->worstCosine(v);
      if (worst < this->Worst - LeastGain && this->isUpright(v))
      {
        this->Worst = worst;
        return true;
      }
    }
    this->Surface.setPoint(v, before);
    this->Surface.setGuess(v, guess);
    return false;
  }

  void place(Index v, const Vec3& point)
  {
    if (this->Curve != NoIndex)
    {
      this->Surface.setPoint(v, this->Reference.onCurve(point, this->Curve));
      return;
    }
    const ReferenceSurface::Foot foot = this->foot(point, this->Surface.guess(v));
    this->Surface.setPoint(v, foot.point + this->Height * foot.normal);
    this->Surface.setGuess(v, foot.triangle);
  }

  bool isUpright(Index v) const
  {
    std::size_t i = 0;
    bool isUpright = true;
    this->Surface.forEachOutgoing(v,
      [&](Index e)
      {
        const Vec3 area = this->Surface.doubleArea(EditableSurface::faceOf(e));
        const Vec3& old = this->OldAreas[i++];
        isUpright = isUpright && area.dot(old) >= LeastCosine * area.norm() * old.norm();
      });
    return isUpright;
  }

  EditableSurface& Surface;
  const ReferenceSurface& Reference;
  Vec3 Normal, U, V;
  Index Label = 0;
  Index Curve = NoIndex;
  double Worst = 0.0;
  double Height = 0.0;
  std::vector<Vec3> OldAreas;
};

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
      { hasMoved[i] = StarSearch(surface, reference).improve(vertices[i].second) ? 1 : 0; },
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
