// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/SheetOpenness.h"

#include "ShrinkWrap/TrianglePlaces.h"

#include <algorithm>
#include <limits>

namespace evolving
{

namespace
{

/// The way to where a side is probed begins so many radii from the target, nearer than thin parts
/// are thick, and leads away from it in steps of this fraction of the distance: not of all of it,
/// for what is reached may touch another part. Each step makes the distance up to 1.9 times as
/// large, so seven lead to the probe's length; the others are for ways that bend.
constexpr double FirstProbe = 0.03;
constexpr double SureStep = 0.9;
constexpr int Climbs = 12;
/// At a sharp edge a triangle's normal leads out on the other side: probes begin farther in, by as
/// much as reachable() takes from none to all.
constexpr double InnerRadii = 0.2;
/// Less openness may be the grid's doing.
constexpr double SurelyOpen = 0.5;

} // namespace

/**
 * How well the ball can come to a side of the target at a point: from just beside it the way leads
 * away from the target, never farther than the target is, so that it cannot cross a thin part.
 */
double SheetOpenness::reachableFrom(Index triangle, const Vec3& point, const Vec3& side) const
{
  const double enough = this->Region.probeLength();
  Vec3 climber = point + FirstProbe * this->Region.radius() * side;
  Index guess = triangle;
  for (int climb = 0; climb < Climbs; ++climb)
  {
    const ClosestTriangle closest =
      this->Tree.closest(climber, std::numeric_limits<double>::infinity(), guess);
    guess = closest.triangle;
    const Vec3 away = climber - closest.at.point;
    const double distance = away.norm();
    if (distance >= enough || !(distance > 0.0))
    {
      break;
    }
    climber += std::min(SureStep, (enough - distance) / distance) * away;
  }
  return this->Region.reachable(climber);
}

double SheetOpenness::at(Index triangle, const Vec3& point) const
{
  return this->above(0.0, triangle, point);
}

double SheetOpenness::above(double least, Index triangle, const Vec3& point) const
{
  const Triangle& t = this->Tree.triangle(triangle);
  const double radius = this->Region.radius();
  const Vec3 normal = t.doubleAreaNormal().stableNormalized();
  const Vec3 inwards = t.centroid() - point;
  const double way = inwards.norm();
  const Vec3 place = way > InnerRadii * radius ? Vec3(point + InnerRadii * radius / way * inwards)
                                               : Vec3(point + inwards);
  const Vec3 probe = this->Region.probeLength() * normal;
  if (this->Region.isFarFrom(place + probe) || this->Region.isFarFrom(place - probe))
  {
    return 0.0;
  }
  const double onOneSide = this->reachableFrom(triangle, place, normal);
  return onOneSide > least ? onOneSide * this->reachableFrom(triangle, place, -normal) : 0.0;
}

SidesOpen SheetOpenness::sidesOf(Index triangle) const
{
  const Triangle& t = this->Tree.triangle(triangle);
  const auto places = placesOf(t);
  const auto isOpen = [&](const Vec3& p)
  { return this->above(SurelyOpen, triangle, p) > SurelyOpen; };
  if (t.box().diagonal().norm() < this->Region.radius())
  {
    return isOpen(places.back()) ? SidesOpen::Both : SidesOpen::One; // as small as a place
  }
  const bool isFirstOpen = isOpen(places.front());
  const bool areAlike = std::all_of(
    places.begin() + 1, places.end(), [&](const Vec3& p) { return isOpen(p) == isFirstOpen; });
  return areAlike ? (isFirstOpen ? SidesOpen::Both : SidesOpen::One) : SidesOpen::Varying;
}

} // namespace evolving
