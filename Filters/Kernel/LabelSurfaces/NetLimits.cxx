// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/NetLimits.h"

#include "ParallelLoops.h"

#include <algorithm>

namespace evolving
{

namespace
{

/// Of a voxel: a little less than half, so that boxes do not touch and points never coincide.
constexpr double Reach = 0.49;
constexpr double ThinReach = 0.25;
/// Of what slides, from the faces of every label: a wedge ends beyond its last voxel.
constexpr double LabelReach = 0.7;
/// Projections onto the plane and the box in turn, which halve the distance between both at least
/// where the plane cuts the box well; where it only just does, the rest is clipped.
constexpr int MostProjections = 20;
/// Of what slides, along each axis from its corner: farther away are other parts of its labels.
constexpr double MostSliding = 1.5;
/// A part with less than this many voxels in the cube of so many to each side of a corner, an
/// eighth of which is 27, is too small for its sheets to say where they end, and keeps its shape.
constexpr Index PartReach = 3;
constexpr Index LeastForPart = 18;
/// Edges from a curve within which the vertices of sheets make room for it.
constexpr int RingsNear = 3;
/// To a sixteenth of the way that is too far.
constexpr int MostHalvings = 5;

/// Calls visit(side, isWedge) for the thin voxels around a corner, by the side of it that they are
/// at; those between two different materials may be the end of a wedge.
template <class Visit>
void forEachThinSide(
  const MaterialGrid& grid, const std::array<Index, 3>& corner, const Visit& visit)
{
  for (Index b = 0; b < 8; ++b)
  {
    const GridIndex voxel =
      grid.voxel(corner[0] - 1 + (b & 1), corner[1] - 1 + (b >> 1 & 1), corner[2] - 1 + (b >> 2));
    for (int axis = 0; axis < 3; ++axis)
    {
      const unsigned isForwards = static_cast<unsigned>(b) >> axis & 1U;
      if (grid.isThin(voxel, axis))
      {
        visit(2U * static_cast<unsigned>(axis) + isForwards, grid.isWedge(voxel, axis));
      }
    }
  }
}

Vec3 clipped(const Vec3& move, const Box& box)
{
  return move.cwiseMax(box.min()).cwiseMin(box.max());
}

Vec3 clippedAlong(const Vec3& normal, const Vec3& move, const Box& box)
{
  Vec3 moved = move;
  for (int i = 0; i < MostProjections; ++i)
  {
    moved = clipped(moved, box);
    moved += normal.dot(move - moved) * normal;
  }
  return clipped(moved, box);
}

/// Vertices of curves, and of sheets up to some edges from them; not those in sides of the image.
std::vector<char> verticesNearCurves(const InterfaceNet& net, const Execution& execution)
{
  std::vector<char> isNear(net.points.size(), 0);
  forEachIndex(execution, net.vertexCount(),
    [&](Index i) { isNear[at(i)] = isInnerJunction(net, i) ? 1 : 0; });
  for (int ring = 0; ring < RingsNear; ++ring)
  {
    const std::vector<char> before = isNear;
    forEachIndex(execution, net.vertexCount(),
      [&](Index i)
      {
        for (Index k = net.edgeOffsets[at(i)]; k < net.edgeOffsets[at(i) + 1]; ++k)
        {
          isNear[at(i)] = std::max(isNear[at(i)], before[at(net.edgeEnds[at(k)])]);
        }
      });
  }
  forEachIndex(execution, net.vertexCount(),
    [&](Index i) { isNear[at(i)] = net.fixed[at(i)] == 0 ? isNear[at(i)] : '\0'; });
  return isNear;
}

} // namespace

NetLimits::NetLimits(const MaterialGrid& grid, const InterfaceNet& net, const Execution& execution)
  : Grid(grid)
  , Fixed(net.fixed)
  , Thin(net.points.size(), 0)
  , Near(verticesNearCurves(net, execution))
  , Slides(net.points.size(), 0)
{
  forEachIndex(execution, net.vertexCount(),
    [&](Index i)
    {
      bool isThread = false;
      if (isSheet(net, i))
      {
        unsigned sides = 0;
        forEachThinSide(grid, net.corners[at(i)],
          [&](unsigned side, bool isWedge)
          {
            sides |= 1U << side;
            isThread = isThread || !isWedge;
          });
        this->Thin[at(i)] = static_cast<std::uint8_t>(sides);
      }
      if (this->Near[at(i)] != 0 && grid.smallestPart(net.corners[at(i)], PartReach) < LeastForPart)
      {
        this->Near[at(i)] = 0;
      }
      this->Slides[at(i)] = isThread ? '\0' : this->Near[at(i)];
    });
}

Box NetLimits::box(Index vertex) const
{
  Box box(Vec3::Constant(-Reach), Vec3::Constant(Reach));
  for (int axis = 0; axis < 3; ++axis)
  {
    const unsigned thin = static_cast<unsigned>(this->Thin[at(vertex)]) >> (2 * axis);
    const bool isFixed = (this->Fixed[at(vertex)] >> axis & 1U) != 0;
    box.min()[axis] = isFixed ? 0.0 : (thin & 1U) != 0 ? -ThinReach : -Reach;
    box.max()[axis] = isFixed ? 0.0 : (thin & 2U) != 0 ? ThinReach : Reach;
  }
  return box;
}

bool NetLimits::isAllowed(const InterfaceNet& net, Index vertex, const Vec3& point) const
{
  if (this->Slides[at(vertex)] == 0)
  {
    return this->box(vertex).contains(Vec3(point - net.cornerPoint(vertex)));
  }
  const Vec3 move = point - net.cornerPoint(vertex);
  if (move.cwiseAbs().maxCoeff() > MostSliding || !this->Grid.isNearInterface(point, Reach))
  {
    return false;
  }
  for (Index k = net.quadOffsets[at(vertex)]; k < net.quadOffsets[at(vertex) + 1]; ++k)
  {
    for (const Material side : net.quads[at(net.quadsOfVertices[at(k)])].sides)
    {
      if (isLabel(side) && !this->Grid.isNearFace(point, side, LabelReach))
      {
        return false;
      }
    }
  }
  return true;
}

Vec3 NetLimits::limited(const InterfaceNet& net, Index vertex, const Vec3& point) const
{
  const Vec3 corner = net.cornerPoint(vertex);
  const Box box = this->box(vertex);
  const Vec3 move = point - corner;
  if (box.contains(move))
  {
    return point;
  }
  // All of the box is allowed, for the corner is one of the faces of all its sheets.
  Vec3 allowed = corner + clipped(move, box);
  if (this->Slides[at(vertex)] == 0)
  {
    return allowed;
  }
  Vec3 tried = point;
  Vec3 half = 0.5 * (point - allowed);
  for (int i = 0; i < MostHalvings; ++i)
  {
    const bool isTriedAllowed = this->isAllowed(net, vertex, tried);
    allowed = isTriedAllowed ? tried : allowed;
    tried += isTriedAllowed ? half : Vec3(-half);
    half *= 0.5;
    if (isTriedAllowed && i == 0)
    {
      break;
    }
  }
  return allowed;
}

void NetLimits::apply(const InterfaceNet& net, const std::vector<Vec3>& normals,
  std::vector<Vec3>& points, const Execution& execution) const
{
  forEachIndex(execution, net.vertexCount(),
    [&](Index i)
    {
      if (!isSheet(net, i) || this->Slides[at(i)] != 0)
      {
        points[at(i)] = this->limited(net, i, points[at(i)]);
        return;
      }
      const Vec3 corner = net.cornerPoint(i);
      const Vec3 move = points[at(i)] - corner;
      const Box allowed = this->box(i);
      if (!allowed.contains(move))
      {
        points[at(i)] = corner + clippedAlong(normals[at(i)], move, allowed);
      }
    });
}

} // namespace evolving
