// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/CollapseCriteria.h"

#include "Remeshing/FaceShape.h"
#include "Trees/TriangleGeometry.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

bool CollapseCriteria::accepts(Index e, Index kept, const Vec3& point) const
{
  const Index a = this->Surface.from(e);
  const Index b = this->Surface.to(e);
  Shapes shapes;
  bool isGood = true;
  for (const Index v : { a, b })
  {
    if (this->Surface.point(v) == point)
    {
      continue; // nothing changes there
    }
    const Index other = v == a ? b : a;
    this->Surface.forEachOutgoing(
      v, [&](Index out) { isGood = isGood && this->mayTurn(out, other, point, shapes); });
    this->Surface.forEachNeighbour(
      v, [&](Index u) { isGood = isGood && (u == other || this->isShortEnough(u, kept, point)); });
  }
  return isGood &&
    (shapes.worstAfter >= this->Guards.leastQuality || shapes.worstAfter > shapes.worstBefore);
}

bool CollapseCriteria::mayCut(Index vanishing, Index kept) const
{
  const Vec3& start = this->Surface.point(kept);
  Vec3 end = start;
  const auto leadTo = [&](Index e, Index u)
  {
    if (this->Surface.opposite(e) == NoIndex && u != kept)
    {
      end = this->Surface.point(u);
    }
  };
  this->Surface.forEachOutgoing(vanishing,
    [&](Index e)
    {
      leadTo(e, this->Surface.to(e));
      leadTo(EditableSurface::previous(e), this->Surface.apex(e));
    });
  const Vec3& point = this->Surface.point(vanishing);
  const double cut =
    std::sqrt(closestPointOnTriangle(point, { { start, end, end } }).squaredDistance);
  return cut <= this->Guards.deepestCut * this->Surface.size(kept);
}

bool CollapseCriteria::isShortEnough(Index u, Index kept, const Vec3& point) const
{
  return (this->Surface.point(u) - point).norm() <
    this->Guards.longest * this->Surface.size(u, kept);
}

/// The face of an edge that leaves a moving vertex; `other` is the one it becomes one with.
bool CollapseCriteria::mayTurn(Index out, Index other, const Vec3& point, Shapes& shapes) const
{
  const Index u = this->Surface.to(out);
  const Index w = this->Surface.apex(out);
  const Vec3& p = this->Surface.point(u);
  const Vec3& q = this->Surface.point(w);
  const Vec3& old = this->Surface.point(this->Surface.from(out));
  shapes.worstBefore = std::min(shapes.worstBefore, faceShape(old, p, q));
  if (u == other || w == other)
  {
    return true; // it vanishes
  }
  const Vec3 normal = (p - point).cross(q - point);
  const Vec3 oldNormal = (p - old).cross(q - old);
  shapes.worstAfter = std::min(shapes.worstAfter, faceShape(point, p, q));
  return normal.dot(oldNormal) >= this->Guards.leastCosine * normal.norm() * oldNormal.norm();
}

} // namespace evolving
