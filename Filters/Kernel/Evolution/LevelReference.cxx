// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/LevelReference.h"

#include "Trees/TrianglePlaces.h"

#include <cmath>

namespace evolving
{

namespace
{

/// Newton's method along a gradient that is 1 almost everywhere; two would nearly always do.
constexpr int Steps = 4;
/// Shorter ones, as half-way between two sides, do not say where to go.
constexpr double SmallestGradient = 0.5;

} // namespace

LevelReference::LevelReference(const ScalarImage& target, const SurfaceMesh& surface,
  const std::vector<double>& distance, const Execution& execution)
  : Target(target)
  , Surface(surface)
  , Distance(distance)
  , Tree(surface, execution)
{
}

double LevelReference::distanceOfSurface(const Vec3& point) const
{
  const TrianglePlace place = closestPlace(this->Tree, point);
  double distance = 0.0;
  for (Index k = 0; k < 3; ++k)
  {
    distance += place.weights[k] * this->Distance[at(this->Surface.faceVertex(place.triangle, k))];
  }
  return std::abs(distance);
}

ReferenceSurface::Foot LevelReference::onSurface(
  const Vec3& point, const Vec3& facing, Index /*label*/, Index guess) const
{
  const double level = this->distanceOfSurface(point);
  Vec3 foot = point;
  for (int step = 0; step < Steps; ++step)
  {
    const ScalarImage::Sample sample = this->Target.at(foot);
    const double slope = sample.gradient.norm();
    const double excess = std::abs(sample.value) - level;
    if (!(excess > 0.0) || slope < SmallestGradient)
    {
      break;
    }
    foot -= std::copysign(excess / (slope * slope), sample.value) * sample.gradient;
  }
  return { foot, facing, guess };
}

} // namespace evolving
