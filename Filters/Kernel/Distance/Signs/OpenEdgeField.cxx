// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/OpenEdgeField.h"

#include "Mesh/Angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace evolving
{

namespace
{

/// The cells of a grid that middles of short pieces of the open edges are in, as points: of
/// thousands of edges in one cell one point.
SurfaceMesh cellsOfOpenEdges(const DistanceTarget& target, double cell)
{
  std::set<std::array<double, 3>> cells;
  for (const auto& [from, to] : target.orientation.openEdges)
  {
    const Vec3& start = target.mesh.points[at(from)];
    const Vec3 way = target.mesh.points[at(to)] - start;
    const double pieces = std::ceil(way.norm() / cell);
    for (double piece = 0.5; piece < pieces; piece += 1.0)
    {
      const Vec3 place = (start + piece / pieces * way) / cell;
      cells.insert({ std::floor(place.x()), std::floor(place.y()), std::floor(place.z()) });
    }
  }
  SurfaceMesh points;
  for (const auto& [x, y, z] : cells)
  {
    const Index point = points.addPoint(cell * Vec3(x + 0.5, y + 0.5, z + 0.5));
    points.addFace({ point, point, point });
  }
  return points;
}

/// A step between samples, but of a model far larger than the grid's part of it not too many.
double cellOfOpenEdges(const DistanceTarget& target, const DistanceGrid& grid)
{
  constexpr double MostPieces = 100000.0;
  return std::max(grid.spacing.maxCoeff(), target.orientation.openLength / MostPieces);
}

} // namespace

OpenEdgeField::OpenEdgeField(const DistanceTarget& target, const DistanceGrid& grid)
  : OpenEdgeField(target, cellOfOpenEdges(target, grid))
{
}

/// @param cell which distances may fall short by, and half of it
OpenEdgeField::OpenEdgeField(const DistanceTarget& target, double cell)
  : Tree(cellsOfOpenEdges(target, cell))
  , Slack((0.5 * std::sqrt(3.0) + 0.5) * cell) // half a cell's diagonal, and half a piece
  , Strength(target.orientation.openLength / (4.0 * Pi))
{
}

double OpenEdgeField::distance(const Vec3& point) const
{
  return this->Tree.isEmpty()
    ? std::numeric_limits<double>::infinity()
    : std::sqrt(this->Tree.closest(point).at.squaredDistance) - this->Slack;
}

} // namespace evolving
