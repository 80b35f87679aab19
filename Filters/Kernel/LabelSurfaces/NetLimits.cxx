// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/NetLimits.h"

#include "ParallelLoops.h"

namespace evolving
{

namespace
{

/// Of a voxel: a little less than half, so that boxes do not touch and points never coincide.
constexpr double Reach = 0.49;
constexpr double ThinReach = 0.25;
/// Projections onto the plane and the box in turn, which halve the distance between both at least
/// where the plane cuts the box well; where it only just does, the rest is clipped.
constexpr int MostProjections = 20;

unsigned thinSides(const MaterialGrid& grid, const std::array<Index, 3>& corner)
{
  unsigned sides = 0;
  for (Index b = 0; b < 8; ++b)
  {
    const GridIndex voxel =
      grid.voxel(corner[0] - 1 + (b & 1), corner[1] - 1 + (b >> 1 & 1), corner[2] - 1 + (b >> 2));
    for (int axis = 0; axis < 3; ++axis)
    {
      const unsigned isForwards = static_cast<unsigned>(b) >> axis & 1U;
      sides |=
        grid.isThin(voxel, axis) ? 1U << (2U * static_cast<unsigned>(axis) + isForwards) : 0U;
    }
  }
  return sides;
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

} // namespace

NetLimits::NetLimits(const MaterialGrid& grid, const InterfaceNet& net, const Execution& execution)
  : Fixed(net.fixed)
  , Thin(net.points.size(), 0)
{
  forEachIndex(execution, net.vertexCount(),
    [&](Index i)
    {
      if (net.kinds[at(i)] == VertexKind::Sheet)
      {
        this->Thin[at(i)] = static_cast<std::uint8_t>(thinSides(grid, net.corners[at(i)]));
      }
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

void NetLimits::apply(const InterfaceNet& net, const std::vector<Vec3>& normals,
  std::vector<Vec3>& points, const Execution& execution) const
{
  forEachIndex(execution, net.vertexCount(),
    [&](Index i)
    {
      const Vec3 corner = net.cornerPoint(i);
      const Vec3 move = points[at(i)] - corner;
      const Box allowed = this->box(i);
      if (allowed.contains(move))
      {
        return;
      }
      const bool isSheet = net.kinds[at(i)] == VertexKind::Sheet;
      points[at(i)] =
        corner + (isSheet ? clippedAlong(normals[at(i)], move, allowed) : clipped(move, allowed));
    });
}

} // namespace evolving
