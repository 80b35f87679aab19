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

class Fairing
{
public:
  Fairing(
    EditableSurface& surface, const ReferenceSurface& reference, const RidgeFairingOptions& options)
    : Surface(surface)
    , Reference(reference)
    , Options(options)
    , SharpCosine(std::cos(options.sharpFold * RadiansPerDegree))
    , TurnCosine(std::cos(options.sharpTurn * RadiansPerDegree))
    , LeastAngleCosine(std::cos(options.leastAngle * RadiansPerDegree))
    , Start(at(surface.vertexSlots()))
    , Normals(at(surface.faceSlots()))
    , IsFold(at(surface.edgeSlots()), 0)
    , HasMoved(at(surface.vertexSlots()), 0)
  {
    for (Index v = 0; v < surface.vertexSlots(); ++v)
    {
      this->Start[at(v)] = surface.point(v);
    }
    std::vector<Index> faces;
    for (Index f = 0; f < surface.faceSlots(); ++f)
    {
      if (surface.hasFace(f))
      {
        faces.push_back(f);
      }
    }
    this->findFolds(faces);
  }

  /// @return whether a vertex has moved
  bool runOnce()
  {
    std::vector<Index> changed;
    for (const Index v : this->verticesOfTeeth())
    {
      if (this->move(v))
      {
        this->Surface.forEachOutgoing(
          v, [&](Index e) { changed.push_back(EditableSurface::faceOf(e)); });
      }
    }
    this->findFolds(changed);
    return !changed.empty();
  }

  Index movedVertices() const
  {
    return static_cast<Index>(std::count(this->HasMoved.begin(), this->HasMoved.end(), 1));
  }

private:
  /// At the edges of faces that have changed.
  void findFolds(const std::vector<Index>& faces)
  {
    for (const Index f : faces)
    {
      this->Normals[at(f)] = this->Surface.doubleArea(f).stableNormalized();
    }
    for (const Index f : faces)
    {
      for (Index e = 3 * f; e < 3 * f + 3; ++e)
      {
        const Index opposite = this->Surface.opposite(e);
        if (opposite != NoIndex)
        {
          const double cosine =
            this->Normals[at(f)].dot(this->Normals[at(EditableSurface::faceOf(opposite))]);
          this->IsFold[at(e)] = this->IsFold[at(opposite)] = cosine < this->SharpCosine ? 1 : 0;
        }
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
    const double allowedCosine =
      std::max(cosineOfSmallestAngleAround(this->Surface, v), this->LeastAngleCosine);
    const double allowedDeviation = this->deviation(v);
    Vec3 away =
      before + Damping * (this->Surface.middleOfNeighbours(v) - before) - this->Start[at(v)];
    const double farthest = this->Options.farthest * this->Surface.size(v);
    const double distance = away.norm();
    away *= distance > farthest ? farthest / distance : 1.0;
    this->Surface.setPoint(v, this->Start[at(v)] + away);
    if (cosineOfSmallestAngleAround(this->Surface, v) > allowedCosine ||
      this->deviation(v) > allowedDeviation)
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
  double LeastAngleCosine;
  std::vector<Vec3> Start;   ///< where vertices were
  std::vector<Vec3> Normals; ///< of faces
  std::vector<char> IsFold;  ///< of each half-edge
  std::vector<char> HasMoved;
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
