// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/ReferenceSurface.h"

#include <limits>

namespace evolving
{

Vec3 ReferenceSurface::onCurve(const Vec3& point, Index /*curve*/) const
{
  return point;
}

OffsetReference::OffsetReference(
  const SurfaceMesh& triangles, double offset, const Execution& execution)
  : Tree(triangles, execution)
  , Offset(offset)
{
}

ReferenceSurface::Foot OffsetReference::onSurface(
  const Vec3& point, const Vec3& facing, Index /*label*/, Index guess) const
{
  const ClosestTriangle closest =
    this->Tree.closest(point, std::numeric_limits<double>::infinity(), guess);
  if (closest.triangle == NoIndex)
  {
    return { point, facing, NoIndex };
  }
  const Vec3& foot = closest.at.point;
  if (this->Offset > 0.0)
  {
    const Vec3 away = point - foot;
    const double distance = away.norm();
    const Vec3 direction = distance > 0.1 * this->Offset ? Vec3(away / distance) : facing;
    return { foot + this->Offset * direction, direction, closest.triangle };
  }
  const Vec3 normal = this->Tree.triangle(closest.triangle).doubleAreaNormal().stableNormalized();
  return { foot, normal.dot(facing) < 0.0 ? Vec3(-normal) : normal, closest.triangle };
}

} // namespace evolving
