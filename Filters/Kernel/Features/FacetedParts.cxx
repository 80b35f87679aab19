// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/FacetedParts.h"

#include "Mesh/Angles.h"
#include "Mesh/ConnectedComponents.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace evolving
{

namespace
{

/// The folds of a part that are seen.
struct PartFolds
{
  bool hasSharp = false;
  double length = 0.0;
  double squared = 0.0; ///< the sum of squared lengths

  bool isFaceted(double leastMean) const
  {
    return !this->hasSharp && this->length > 0.0 && this->squared >= leastMean * this->length;
  }
};

/// Of the edges that fold by more than an angle those of faceted parts, the largest folds first.
std::vector<Index> foldsOfFacets(
  const TargetTriangles& target, const SharpEdges& sharp, const FacetFolds& folds, double leastMean)
{
  const ConnectedComponents parts = connectedComponents(target.mesh());
  const auto partOf = [&](Index edge)
  { return at(parts.ofVertex[at(target.edgeVertices(edge)[0])]); };
  std::vector<PartFolds> ofPart(at(parts.count));
  std::vector<Index> folded;
  for (Index edge = 0; edge < target.edges().edgeCount(); ++edge)
  {
    PartFolds& part = ofPart[partOf(edge)];
    part.hasSharp = part.hasSharp || sharp.isSharp(edge);
    if (target.edges().faceCount(edge) == 2 && sharp.foldsBeyond(edge, folds.faint))
    {
      folded.push_back(edge);
      const double length = sharp.foldsBeyond(edge, folds.seen) ? target.edgeLength(edge) : 0.0;
      part.length += length;
      part.squared += length * length;
    }
  }
  folded.erase(std::remove_if(folded.begin(), folded.end(),
                 [&](Index edge) { return !ofPart[partOf(edge)].isFaceted(leastMean); }),
    folded.end());
  std::stable_sort(
    folded.begin(), folded.end(), [&](Index a, Index b) { return sharp.fold(a) > sharp.fold(b); });
  return folded;
}

/// The edges that have been taken in at each vertex, as ways to their other ends.
class TakenEdges
{
public:
  explicit TakenEdges(const TargetTriangles& target)
    : Target(target)
    , Ways(target.mesh().points.size())
  {
  }

  /// In radians, to the closest one; infinite where there is none.
  double leastAngleTo(Index edge) const
  {
    const auto [a, b] = this->Target.edgeVertices(edge);
    const Vec3 way = this->Target.point(b) - this->Target.point(a);
    return std::min(this->leastAngle(a, way), this->leastAngle(b, -way));
  }

  void add(Index edge)
  {
    const auto [a, b] = this->Target.edgeVertices(edge);
    const Vec3 way = this->Target.point(b) - this->Target.point(a);
    this->Ways[at(a)].push_back(way);
    this->Ways[at(b)].push_back(-way);
  }

private:
  double leastAngle(Index vertex, const Vec3& way) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& other : this->Ways[at(vertex)])
    {
      least = std::min(least, angleBetween(way, other));
    }
    return least;
  }

  const TargetTriangles& Target;
  std::vector<std::vector<Vec3>> Ways;
};

} // namespace

void takeFacetEdges(
  const TargetTriangles& target, SharpEdges& sharp, const FacetFolds& folds, double leastMean)
{
  TakenEdges taken(target);
  for (const Index edge : foldsOfFacets(target, sharp, folds, leastMean))
  {
    if (sharp.foldsBeyond(edge, folds.seen) ||
      taken.leastAngleTo(edge) >= folds.leastWedge * RadiansPerDegree)
    {
      sharp.takeIn(edge);
      taken.add(edge);
    }
  }
}

} // namespace evolving
