// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/SurfaceProjector.h"

#include "Mesh/PolygonTriangulation.h"

#include <vector>

namespace evolving
{

namespace
{

SurfaceMesh triangulated(const SurfaceMesh& surface, const Execution& execution)
{
  std::vector<Index> oldFace;
  return triangulate(surface, oldFace, execution);
}

} // namespace

SurfaceProjector::SurfaceProjector(const SurfaceMesh& surface, const Execution& execution)
  : Tree(triangulated(surface, execution.phase(0.0, 0.2)), execution.phase(0.2, 1.0))
{
}

Vec3 SurfaceProjector::project(const Vec3& point, const Vec3& normal, const Vec3& fallback) const
{
  const ClosestTriangle closest = this->Tree.closest(point);
  if (closest.triangle == NoIndex)
  {
    return fallback;
  }
  const Vec3 facing = this->Tree.triangle(closest.triangle).doubleAreaNormal();
  return facing.dot(normal) < 0.0 ? fallback : closest.at.point;
}

} // namespace evolving
