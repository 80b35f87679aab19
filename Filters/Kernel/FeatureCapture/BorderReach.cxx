// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCapture/BorderReach.h"

#include "Mesh/Angles.h"
#include "Remeshing/EdgeLengthLimits.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// In sizes: of blunt creases, the length of an edge, and the rest is for bends.
constexpr double BluntReach = 1.5;
/// In sizes: of creases of six degrees and less. The passes before capture do not wear off more.
constexpr double MostReach = 12.0;

/// How far from an acute crease an edge of the longest length leads from side to side, in sizes.
double distanceAcross(double angle)
{
  constexpr double LeastAngle = 1e-6; // of sides that are one, to divide by its sine
  return LongestPerSize / (2.0 * std::sin(std::max(0.5 * angle, LeastAngle)));
}

} // namespace

BorderReach::BorderReach(const EditableSurface& surface, const TargetFeatures& features)
  : Features(features)
{
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    this->Largest = surface.hasVertex(v) ? std::max(this->Largest, surface.size(v)) : this->Largest;
  }
}

double BorderReach::ofEdge(Index targetEdge, double size) const
{
  const double angle = Pi - this->Features.sharpEdges().fold(targetEdge) * RadiansPerDegree;
  const double worn = std::clamp(distanceAcross(angle), BluntReach, MostReach) - BluntReach;
  return BluntReach * size + worn * this->Largest;
}

double BorderReach::ofCorner(Index targetVertex, double size) const
{
  const TargetTriangles& target = this->Features.target();
  double reach = BluntReach * size;
  for (const Index* f = target.facesBegin(targetVertex); f != target.facesEnd(targetVertex); ++f)
  {
    for (Index k = 0; k < 3; ++k)
    {
      const Index edge = target.edgeOfFace(*f, k);
      const auto [a, b] = target.edgeVertices(edge);
      if ((a == targetVertex || b == targetVertex) && this->Features.sharpEdges().isSharp(edge))
      {
        reach = std::max(reach, this->ofEdge(edge, size));
      }
    }
  }
  return reach;
}

Vec3 BorderReach::onBorder(const Vec3& point, Index a, Index b, double size) const
{
  const EdgePoint closest = this->Features.borders().closest(point, a, b);
  const double reach = closest.exists() ? this->ofEdge(closest.edge, size) : 0.0;
  return closest.squaredDistance <= reach * reach ? closest.point : point;
}

} // namespace evolving
