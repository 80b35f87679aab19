// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/CrossingLines.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

GridPoint CrossingLines::place(Index triangle, Index number) const
{
  if (number < this->firstCrossing())
  {
    return this->atCorner(triangle, number);
  }
  if (number < this->firstTriple())
  {
    const CrossingPoint& crossing = this->Crossings.points[at(number - this->firstCrossing())];
    for (Index k = 0; k < 3; ++k)
    {
      if (this->Edges.edgeOf(3 * triangle + k) == crossing.edge)
      {
        return this->onSide(triangle, k, crossing.along);
      }
    }
  }
  return this->inTriangle(triangle, this->point(number));
}

GridPoint CrossingLines::atCorner(Index triangle, Index vertex) const
{
  if (vertex == this->Mesh.faceVertex(triangle, 0))
  {
    return { 0, 0 };
  }
  return vertex == this->Mesh.faceVertex(triangle, 1) ? GridPoint{ GridPoint::Unit, 0 }
                                                      : GridPoint{ 0, GridPoint::Unit };
}

/// On side k, which begins at corner k.
GridPoint CrossingLines::onSide(Index triangle, Index k, std::int64_t along) const
{
  const bool runsUpwards = TriangleEdges::runsUpwards(this->Mesh, 3 * triangle + k);
  const std::int64_t way = runsUpwards ? along : GridPoint::Unit - along;
  switch (k)
  {
    case 0:
      return { way, 0 };
    case 1:
      return { GridPoint::Unit - way, way };
    default:
      return { 0, GridPoint::Unit - way };
  }
}

/// Strictly inside.
GridPoint CrossingLines::inTriangle(Index triangle, const Vec3& point) const
{
  const Vec3& origin = this->Mesh.facePoint(triangle, 0);
  const Vec3 a = this->Mesh.facePoint(triangle, 1) - origin;
  const Vec3 b = this->Mesh.facePoint(triangle, 2) - origin;
  const Vec3 p = point - origin;
  const Vec3 normal = a.cross(b);
  const auto toGrid = [&normal](const Vec3& part)
  {
    const double place =
      part.dot(normal) / normal.squaredNorm() * static_cast<double>(GridPoint::Unit);
    const double largest = static_cast<double>(GridPoint::Unit - 2);
    return std::isfinite(place) ? std::llround(std::clamp(place, 1.0, largest)) : 1;
  };
  const std::int64_t x = toGrid(p.cross(b));
  return { x, std::min<std::int64_t>(toGrid(a.cross(p)), GridPoint::Unit - 1 - x) };
}

} // namespace evolving
