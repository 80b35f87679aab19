// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapReference.h"

#include "ParallelLoops.h"
#include "ShrinkWrap/ClosedParts.h"
#include "ShrinkWrap/SurfaceReport.h"
#include "ShrinkWrap/TrianglePlaces.h"
#include "Trees/Barycentric.h"
#include "Trees/TriangleGeometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace evolving
{

namespace
{

/// A point nearer than this to its foot, in levels, does not say on which side it lies: chords of
/// elements cut so deep.
constexpr double SureSide = 0.1;
/// Where the closest point is on one wall, another may be too near: it pushes away. As often as
/// walls meet in a corner; less than this part of the level is not pushed any more.
constexpr int Pushes = 3;
constexpr double NearlyAtLevel = 0.98;

/// Some triangles of a target.
struct PartOfTarget
{
  SurfaceMesh mesh;
  std::vector<char> hasInside; ///< of each triangle, in the whole target
};

/// The triangles that the ball comes near to; all, when it comes near to none.
PartOfTarget withoutHidden(
  const SurfaceMesh& surface, const OuterRegion& region, double thinnestWall)
{
  constexpr double Thin = 1.2; // in halves of walls: closer layers would fold through each other
  const std::vector<char> hasInside = facesOfClosedParts(surface, Thin * thinnestWall);
  PartOfTarget kept;
  kept.mesh.points = surface.points;
  for (Index f = 0; f < surface.faceCount(); ++f)
  {
    const Triangle triangle = triangleOf(surface, f);
    const Vec3 probe = region.probeLength() * triangle.doubleAreaNormal().stableNormalized();
    const auto places = placesOf(triangle);
    const bool isHidden = std::all_of(places.begin(), places.end(),
      [&](const Vec3& p) { return region.isFarFrom(p + probe) && region.isFarFrom(p - probe); });
    if (!isHidden)
    {
      kept.mesh.addFace(
        { surface.faceVertex(f, 0), surface.faceVertex(f, 1), surface.faceVertex(f, 2) });
      kept.hasInside.push_back(hasInside[at(f)]);
    }
  }
  return kept.mesh.faceCount() > 0 ? kept : PartOfTarget{ surface, hasInside };
}

} // namespace

WrapReference::WrapReference(
  const WrapTarget& target, const OuterRegion& region, const Execution& execution)
  : Tree(SurfaceMesh())
  , Offset(target.offset)
  , Wall(target.wall)
  , Reach(FarEdges * target.edgeLength)
{
  PartOfTarget reached = withoutHidden(target.surface, region, target.thinnestWall());
  this->Visible = std::move(reached.mesh);
  this->Tree = AABBTree(this->Visible, execution.phase(0.0, 0.3));
  this->Levels = wrapLevels(this->Visible, this->Tree, reached.hasInside, region, target.offset,
    target.wall, execution.phase(0.3, 0.6));
  if (this->Levels.triangles.faceCount() != this->Tree.triangleCount())
  {
    this->Tree = AABBTree(this->Levels.triangles, execution.phase(0.6, 0.8));
  }
  this->findSheets(execution.phase(0.8, 1.0));
}

std::size_t WrapReference::bytes() const
{
  // A triangle is held as corners and as measured, and has, by the surface area heuristic, about
  // two nodes of the binary tree and one of its wide form.
  constexpr std::size_t OfTree =
    sizeof(Triangle) + sizeof(MeasuredTriangle<double>) + 3 * sizeof(BoxNode) + 4 * sizeof(Index);
  // Of the mesh half a vertex.
  constexpr std::size_t OfMesh = sizeof(Vec3) / 2 + 4 * sizeof(Index);
  const auto count = [](Index triangles) { return static_cast<std::size_t>(triangles); };
  return count(this->Visible.faceCount()) * OfMesh +
    count(this->Levels.triangles.faceCount()) * (OfMesh + 3 * sizeof(double)) +
    count(this->Tree.triangleCount() + (this->Sheets ? this->Sheets->triangleCount() : 0)) * OfTree;
}

void WrapReference::findSheets(const Execution& execution)
{
  SurfaceMesh sheets;
  sheets.points = this->Levels.triangles.points;
  for (Index t = 0; t < this->Tree.triangleCount(); ++t)
  {
    if (this->Levels.maximum(t) > this->Offset)
    {
      this->SheetNumbers.push_back(t);
      sheets.addFace({ this->Levels.triangles.faceVertex(t, 0),
        this->Levels.triangles.faceVertex(t, 1), this->Levels.triangles.faceVertex(t, 2) });
    }
  }
  this->HasSheets = !this->SheetNumbers.empty();
  this->SheetArea = surfaceArea(sheets);
  this->Sheets = std::make_unique<AABBTree>(sheets, execution);
}

double WrapReference::levelAt(Index triangle, const Vec3& point) const
{
  const std::array<double, 3>& levels = this->Levels.atCorners[at(triangle)];
  if (levels[0] == levels[1] && levels[0] == levels[2])
  {
    return levels[0];
  }
  const Vec3 weights = barycentricCoordinates(this->Tree.triangle(triangle), point);
  const double level = weights.dot(Vec3(levels[0], levels[1], levels[2]));
  return std::isfinite(level) ? level : this->Levels.maximum(triangle);
}

double WrapReference::deviation(const Vec3& point) const
{
  const ClosestTriangle closest = this->Tree.closest(point);
  const double distance = (point - closest.at.point).norm();
  return std::abs(distance - this->levelAt(closest.triangle, closest.at.point));
}

bool WrapReference::isAtSheet(const Vec3& point) const
{
  const ClosestTriangle closest = this->Tree.closest(point);
  return this->levelAt(closest.triangle, closest.at.point) > this->Offset;
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
