// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/StarSearch.h"

#include "Mesh/Orthogonal.h"
#include "Remeshing/FaceShape.h"
#include "Remeshing/Relaxation.h"

#include <algorithm>
#include <array>
#include <utility>

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
/// The cosine must fall by this much, or rounding would go on for ever.
constexpr double LeastGain = 1e-7;

} // namespace

StarSearch::StarSearch(EditableSurface& surface, const ReferenceSurface& reference)
  : Surface(surface)
  , Reference(reference)
{
}

bool StarSearch::improve(Index v)
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

double StarSearch::worstCosineAt(const Vec3& point) const
{
  double worst = 0.0;
  for (const auto& [from, to] : this->Rim)
  {
    worst = std::max(worst, cosineOfSmallestAngle(point, from, to));
  }
  return worst;
}

/// The first face that is no better says it: most tries fail, and at the face where the last did.
bool StarSearch::isBetter(const Vec3& point)
{
  for (std::array<Vec3, 2>& side : this->Rim)
  {
    if (!hasSmallerCosine(point, side[0], side[1], this->Worst))
    {
      std::swap(side, this->Rim.front());
      return false;
    }
  }
  return this->Worst > 0.0;
}

void StarSearch::begin(Index v)
{
  const Vec3 normal = this->Surface.normal(v);
  this->U = orthogonalTo(normal).normalized();
  this->V = normal.cross(this->U);
  this->Normal = normal;
  this->Label = 0;
  this->OldAreas.clear();
  this->Rim.clear();
  this->Surface.forEachOutgoing(v,
    [&](Index e)
    {
      this->Label = this->Surface.label(EditableSurface::faceOf(e));
      this->OldAreas.push_back(this->Surface.doubleArea(EditableSurface::faceOf(e)));
      this->Rim.push_back(
        { this->Surface.point(this->Surface.to(e)), this->Surface.point(this->Surface.apex(e)) });
    });
  this->Worst = this->worstCosineAt(this->Surface.point(v));
  const ReferenceSurface::Foot foot = this->foot(this->Surface.point(v), this->Surface.guess(v));
  this->Height =
    this->Curve == NoIndex ? (this->Surface.point(v) - foot.point).dot(foot.normal) : 0.0;
}

ReferenceSurface::Foot StarSearch::foot(const Vec3& point, Index guess) const
{
  return this->Reference.onSurface(point, this->Normal, this->Label, guess);
}

/// Tries all directions at one distance, as long as one helps.
bool StarSearch::searchAt(Index v, double move)
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

bool StarSearch::tryMove(Index v, const Vec3& move)
{
  const Vec3 before = this->Surface.point(v);
  const Index guess = this->Surface.guess(v);
  // Most tries fail already in the tangent plane: the search for the foot is what costs.
  if (!this->isBetter(before + move))
  {
    return false;
  }
  this->place(v, before + move);
  const double worst = this->worstCosineAt(this->Surface.point(v));
  if (worst < this->Worst - LeastGain && this->isUpright(v))
  {
    this->Worst = worst;
    return true;
  }
  this->Surface.setPoint(v, before);
  this->Surface.setGuess(v, guess);
  return false;
}

void StarSearch::place(Index v, const Vec3& point)
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

bool StarSearch::isUpright(Index v) const
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

} // namespace evolving
