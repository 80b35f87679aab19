// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/RidgeFairing.h"

#include "Mesh/Angles.h"
#include "Remeshing/FaceShape.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace evolving
{

namespace
{

/// Of the way to the middle of the neighbours: all of it would swing.
constexpr double Damping = 0.5;

double cosineOfDegrees(double degrees)
{
  return std::cos(degrees * Pi / 180.0);
}

class Fairing
{
public:
  Fairing(
    EditableSurface& surface, const ReferenceSurface& reference, const RidgeFairingOptions& options)
    : Surface(surface)
    , Reference(reference)
    , Options(options)
    , SharpCosine(cosineOfDegrees(options.sharpFold))
    , TurnCosine(cosineOfDegrees(options.sharpTurn))
    , Start(at(surface.vertexSlots()))
    , HasMoved(at(surface.vertexSlots()), 0)
  {
    for (Index v = 0; v < surface.vertexSlots(); ++v)
    {
      this->Start[at(v)] = surface.point(v);
    }
  }

  /// @return whether a vertex has moved
  bool runOnce()
  {
    this->findFolds();
    bool hasMoved = false;
    for (const Index v : this->verticesOfTeeth())
    {
      hasMoved = this->move(v) || hasMoved;
    }
    return hasMoved;
  }

  Index movedVertices() const
  {
    return static_cast<Index>(std::count(this->HasMoved.begin(), this->HasMoved.end(), 1));
  }

private:
  void findFolds()
  {
    this->IsFold.assign(at(this->Surface.edgeSlots()), 0);
    std::vector<Vec3> normals(at(this->Surface.faceSlots()));
    for (Index f = 0; f < this->Surface.faceSlots(); ++f)
    {
      if (this->Surface.hasFace(f))
      {
        normals[at(f)] = this->Surface.doubleArea(f).stableNormalized();
      }
    }
    for (Index e = 0; e < this->Surface.edgeSlots(); ++e)
    {
      const Index opposite = this->Surface.hasEdge(e) ? this->Surface.opposite(e) : NoIndex;
      if (opposite != NoIndex)
      {
        const double cosine = normals[at(EditableSurface::faceOf(e))].dot(
          normals[at(EditableSurface::faceOf(opposite))]);
        this->IsFold[at(e)] = cosine < this->SharpCosine ? 1 : 0;
      }
    }
  }

  Vec3 direction(Index e) const
  {
    return (this->Surface.point(this->Surface.to(e)) - this->Surface.point(this->Surface.from(e)))
      .stableNormalized();
  }

  /// Where curves meet, the boundary is, or a vertex is pinned, folds end as the target's do.
  bool isCorner(Index v) const
  {
    const Index features = this->Surface.featureEdges(v);
    return this->Surface.isPinned(v) || this->Surface.isBoundary(v) ||
      (features != 0 && features != 2);
  }

  /// Does the fold of an edge go on where the edge begins?
  bool goesOn(Index e) const
  {
    const Vec3 along = this->direction(e);
    bool doesGoOn = false;
    this->Surface.forEachOutgoing(this->Surface.from(e),
      [&](Index other)
      {
        doesGoOn = doesGoOn ||
          (this->IsFold[at(other)] != 0 && -this->direction(other).dot(along) > this->TurnCosine);
      });
    return doesGoOn;
  }

  bool isTooth(Index e) const
  {
    return this->IsFold[at(e)] != 0 && !this->Surface.isFeature(e) &&
      !this->isCorner(this->Surface.from(e)) && !this->goesOn(e);
  }

  /// In order, those that may move.
  std::vector<Index> verticesOfTeeth() const
  {
    std::vector<char> isWanted(at(this->Surface.vertexSlots()), 0);
    for (Index e = 0; e < this->Surface.edgeSlots(); ++e)
    {
      if (this->isTooth(e))
      {
        for (const Index v : { this->Surface.from(e), this->Surface.to(e) })
        {
          isWanted[at(v)] = 1;
          this->Surface.forEachNeighbour(v, [&](Index w) { isWanted[at(w)] = 1; });
        }
      }
    }
    std::vector<Index> vertices;
    for (Index v = 0; v < this->Surface.vertexSlots(); ++v)
    {
      if (isWanted[at(v)] != 0 && this->isFree(v))
      {
        vertices.push_back(v);
      }
    }
    return vertices;
  }

  bool isFree(Index v) const
  {
    return !this->Surface.isPinned(v) && !this->Surface.isBoundary(v) &&
      this->Surface.featureEdges(v) == 0;
  }

  Vec3 middleOfNeighbours(Index v) const
  {
    Vec3 sum = Vec3::Zero();
    Index count = 0;
    this->Surface.forEachNeighbour(v,
      [&](Index w)
      {
        sum += this->Surface.point(w);
        ++count;
      });
    return sum / static_cast<double>(count);
  }

  double worstCosine(Index v) const
  {
    double worst = 0.0;
    this->Surface.forEachOutgoing(v,
      [&](Index e) {
        worst = std::max(worst, cosineOfSmallestAngle(this->Surface, EditableSurface::faceOf(e)));
      });
    return worst;
  }

  /// How far the directions of the faces at a vertex are from the reference's, by area.
  double deviation(Index v) const
  {
    double sum = 0.0;
    this->Surface.forEachOutgoing(v,
      [&](Index e)
      {
        const Index f = EditableSurface::faceOf(e);
        const Vec3 doubleArea = this->Surface.doubleArea(f);
        const Vec3 center =
          (this->Surface.corner(f, 0) + this->Surface.corner(f, 1) + this->Surface.corner(f, 2)) /
          3.0;
        const ReferenceSurface::Foot foot = this->Reference.onSurface(
          center, doubleArea.stableNormalized(), this->Surface.label(f), this->Surface.guess(v));
        sum += doubleArea.norm() - doubleArea.dot(foot.normal);
      });
    return sum;
  }

  bool move(Index v)
  {
    const Vec3 before = this->Surface.point(v);
    const double allowed =
      std::max(this->worstCosine(v), cosineOfDegrees(this->Options.leastAngle));
    const double allowedDeviation = this->deviation(v);
    Vec3 away = before + Damping * (this->middleOfNeighbours(v) - before) - this->Start[at(v)];
    const double farthest = this->Options.farthest * this->Surface.size(v);
    const double distance = away.norm();
    away *= distance > farthest ? farthest / distance : 1.0;
    this->Surface.setPoint(v, this->Start[at(v)] + away);
    if (this->worstCosine(v) > allowed || this->deviation(v) > allowedDeviation)
    {
      this->Surface.setPoint(v, before);
      return false;
    }
    this->HasMoved[at(v)] = 1;
    return true;
  }

  EditableSurface& Surface;
  const ReferenceSurface& Reference;
  const RidgeFairingOptions& Options;
  double SharpCosine;
  double TurnCosine;
  std::vector<Vec3> Start; ///< where vertices were
  std::vector<char> HasMoved;
  std::vector<char> IsFold; ///< of each half-edge
};

} // namespace

Index fairRidges(EditableSurface& surface, const ReferenceSurface& reference,
  const RidgeFairingOptions& options, const Execution& execution)
{
  Fairing fairing(surface, reference, options);
  for (int round = 0; round < options.rounds && fairing.runOnce(); ++round)
  {
    execution.report(0.0);
  }
  return fairing.movedVertices();
}

} // namespace evolving
