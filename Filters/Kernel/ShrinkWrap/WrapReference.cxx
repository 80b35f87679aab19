// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapReference.h"

#include "Distance/TriangleGeometry.h"
#include "ParallelLoops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace evolving
{

namespace
{

constexpr double ReachEdges = 2.0;
/// A point nearer than this to its foot, in levels, does not say on which side it lies.
constexpr double SureSide = 0.1;
/// A sheet's side is probed so many radii of the region's ball away.
constexpr double ProbeRadii = 1.5;
/// The way there begins so many radii from the target, and leads away from it in steps of this
/// fraction of the distance.
constexpr double FirstProbe = 0.03;
/// At a sharp edge a triangle's normal leads out on the other side: probes begin farther in.
constexpr double InnerRadii = 0.2;
constexpr double SureStep = 0.9;
constexpr int Climbs = 12;
/// Where the closest point is on one wall, another may be too near: so often it pushes away.
constexpr int Pushes = 3;
constexpr double NearlyAtLevel = 0.98;
/// Less openness may be the grid's doing.
constexpr double SurelyOpen = 0.5;

/// The corners, the middles of the edges and the centroid.
std::array<Vec3, 7> placesOf(const Triangle& t)
{
  const auto& [a, b, c] = t.corners;
  return { a, b, c, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a), (a + b + c) / 3.0 };
}

/// The triangles that the ball comes near to; all, when it comes near to none.
SurfaceMesh withoutHidden(const SurfaceMesh& surface, const OuterRegion& region)
{
  SurfaceMesh kept;
  kept.points = surface.points;
  for (Index f = 0; f < surface.faceCount(); ++f)
  {
    const Triangle triangle = triangleOf(surface, f);
    const Vec3 probe =
      ProbeRadii * region.radius() * triangle.doubleAreaNormal().stableNormalized();
    const auto places = placesOf(triangle);
    const bool isHidden = std::all_of(places.begin(), places.end(),
      [&](const Vec3& p) { return region.isFarFrom(p + probe) && region.isFarFrom(p - probe); });
    if (!isHidden)
    {
      kept.addFace(
        { surface.faceVertex(f, 0), surface.faceVertex(f, 1), surface.faceVertex(f, 2) });
    }
  }
  return kept.faceCount() > 0 ? kept : surface;
}

} // namespace

WrapReference::WrapReference(
  const WrapTarget& target, std::shared_ptr<const OuterRegion> region, const Execution& execution)
  : Visible(withoutHidden(target.surface, *region))
  , Tree(this->Visible, execution.phase(0.0, 0.5))
  , Region(std::move(region))
  , Offset(target.offset)
  , Wall(target.wall)
  , Reach(ReachEdges * target.edgeLength)
{
  this->findSheets(execution.phase(0.5, 1.0));
}

WrapReference::SidesOpen WrapReference::sidesOf(Index triangle) const
{
  const Triangle& t = this->Tree.triangle(triangle);
  const auto places = placesOf(t);
  const auto isOpen = [&](const Vec3& p) { return this->openness(triangle, p) > SurelyOpen; };
  if (t.box().diagonal().norm() < this->Region->radius())
  {
    return isOpen(places.back()) ? SidesOpen::Both : SidesOpen::One; // as small as a place
  }
  const auto open = std::count_if(places.begin(), places.end(), isOpen);
  if (open == 0)
  {
    return SidesOpen::One;
  }
  return open == static_cast<std::ptrdiff_t>(places.size()) ? SidesOpen::Both : SidesOpen::Varying;
}

void WrapReference::findSheets(const Execution& execution)
{
  this->Sides.assign(at(this->Tree.triangleCount()), SidesOpen::One);
  execution.forRange(this->Tree.triangleCount(), Execution::MeshGrain,
    [this](std::int64_t begin, std::int64_t end)
    {
      for (auto t = static_cast<Index>(begin); t < static_cast<Index>(end); ++t)
      {
        this->Sides[at(t)] = this->sidesOf(t);
      }
    });
  SurfaceMesh sheets;
  sheets.points = this->Visible.points;
  for (Index t = 0; t < this->Tree.triangleCount(); ++t)
  {
    if (this->Sides[at(t)] != SidesOpen::One)
    {
      this->SheetNumbers.push_back(t);
      sheets.addFace({ this->Visible.faceVertex(t, 0), this->Visible.faceVertex(t, 1),
        this->Visible.faceVertex(t, 2) });
    }
  }
  this->HasSheets = !this->SheetNumbers.empty();
  this->Sheets = std::make_unique<AABBTree>(sheets, execution);
}

/**
 * How well the ball can come to a side of the target at a point: from just beside it the way leads
 * away from the target, never farther than the target is, so that it cannot cross a thin part.
 */
double WrapReference::reachableFrom(const Vec3& point, const Vec3& side) const
{
  const double enough = ProbeRadii * this->Region->radius();
  Vec3 climber = point + FirstProbe * this->Region->radius() * side;
  for (int climb = 0; climb < Climbs; ++climb)
  {
    const ClosestTriangle closest = this->Tree.closest(climber);
    const Vec3 away = climber - closest.at.point;
    const double distance = away.norm();
    if (distance >= enough || !(distance > 0.0))
    {
      break;
    }
    climber += std::min(SureStep, (enough - distance) / distance) * away;
  }
  return this->Region->reachable(climber);
}

double WrapReference::openness(Index triangle, const Vec3& point) const
{
  const Triangle& t = this->Tree.triangle(triangle);
  const double radius = this->Region->radius();
  const Vec3 normal = t.doubleAreaNormal().stableNormalized();
  const Vec3 inwards = (t.corners[0] + t.corners[1] + t.corners[2]) / 3.0 - point;
  const double way = inwards.norm();
  const Vec3 place = way > InnerRadii * radius ? Vec3(point + InnerRadii * radius / way * inwards)
                                               : Vec3(point + inwards);
  const Vec3 probe = ProbeRadii * radius * normal;
  if (this->Region->isFarFrom(place + probe) || this->Region->isFarFrom(place - probe))
  {
    return 0.0;
  }
  const double above = this->reachableFrom(place, normal);
  return above > 0.0 ? above * this->reachableFrom(place, -normal) : 0.0;
}

double WrapReference::levelAt(Index triangle, const Vec3& point) const
{
  switch (this->Sides[at(triangle)])
  {
    case SidesOpen::One:
      return this->Offset;
    case SidesOpen::Both:
      return std::max(this->Offset, this->Wall);
    default:
      return std::max(this->Offset, this->Wall * this->openness(triangle, point));
  }
}

double WrapReference::deviation(const Vec3& point) const
{
  const ClosestTriangle closest = this->Tree.closest(point);
  const double distance = (point - closest.at.point).norm();
  return std::abs(distance - this->levelAt(closest.triangle, closest.at.point));
}

ReferenceSurface::Foot WrapReference::onSurface(
  const Vec3& point, const Vec3& facing, Index /*label*/, Index guess) const
{
  Foot foot = this->onVisible(point, facing, guess);
  for (int push = 0; this->HasSheets && push < Pushes; ++push)
  {
    const Vec3 pushed = this->awayFromSheets(foot.point);
    if (pushed == foot.point)
    {
      break;
    }
    foot = this->onVisible(pushed, foot.normal, foot.triangle);
  }
  return foot;
}

ReferenceSurface::Foot WrapReference::onVisible(
  const Vec3& point, const Vec3& facing, Index guess) const
{
  const ClosestTriangle closest =
    this->Tree.closest(point, std::numeric_limits<double>::infinity(), guess);
  const Vec3& foot = closest.at.point;
  const double level = this->levelAt(closest.triangle, foot);
  const Vec3 away = point - foot;
  const double distance = away.norm();
  if (std::abs(distance - level) > this->Reach)
  {
    return { point, facing, closest.triangle };
  }
  if (level > 0.0 && distance > SureSide * level)
  {
    const Vec3 direction = away / distance;
    return { foot + level * direction, direction, closest.triangle };
  }
  const Vec3 normal = this->Tree.triangle(closest.triangle).doubleAreaNormal().stableNormalized();
  const Vec3 upward = normal.dot(facing) < 0.0 ? Vec3(-normal) : normal;
  return { foot + level * upward, upward, closest.triangle };
}

Vec3 WrapReference::awayFromSheets(const Vec3& point) const
{
  const ClosestTriangle sheet = this->Sheets->closest(point, this->Wall * this->Wall);
  if (sheet.triangle == NoIndex)
  {
    return point;
  }
  const Vec3 away = point - sheet.at.point;
  const double distance = away.norm();
  const double level = this->levelAt(this->SheetNumbers[at(sheet.triangle)], sheet.at.point);
  const bool isNear = distance < NearlyAtLevel * level && distance > 0.0;
  return isNear ? Vec3(sheet.at.point + level / distance * away) : point;
}

} // namespace evolving
