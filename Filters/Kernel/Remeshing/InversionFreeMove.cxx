// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/InversionFreeMove.h"

#include "ParallelLoops.h"

namespace evolving
{

namespace
{

/// 75 degrees: not yet a right angle, from which on a second move could turn a face over.
constexpr double LeastCosine = 0.25;

/// Marks the faces that have turned from where their corners were before.
void markTurned(const EditableSurface& surface, const std::vector<Vec3>& before,
  std::vector<char>& isTurned, const Execution& execution)
{
  const auto oldArea = [&](Index f) -> Vec3
  {
    const Vec3& origin = before[at(surface.from(3 * f))];
    return (before[at(surface.from(3 * f + 1))] - origin)
      .cross(before[at(surface.from(3 * f + 2))] - origin);
  };
  forEachIndex(execution, surface.faceSlots(),
    [&](Index f)
    {
      isTurned[at(f)] = 0;
      if (surface.hasFace(f))
      {
        const Vec3 was = oldArea(f);
        const Vec3 is = surface.doubleArea(f);
        // A move that is no number is none to keep.
        const bool isUpright = is.dot(was) >= LeastCosine * is.norm() * was.norm();
        isTurned[at(f)] = isUpright ? 0 : 1;
      }
    });
}

} // namespace

Index moveWithoutInversion(
  EditableSurface& surface, const std::vector<Vec3>& points, const Execution& execution)
{
  std::vector<Vec3> before(points.size());
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    before[at(v)] = surface.point(v);
    surface.setPoint(v, points[at(v)]);
  }
  std::vector<char> isTurned(at(surface.faceSlots()), 0);
  std::vector<char> stays(points.size(), 0);
  Index count = 0;
  for (Index found = 1; found > 0;)
  {
    markTurned(surface, before, isTurned, execution);
    found = 0;
    for (Index e = 0; e < surface.edgeSlots(); ++e)
    {
      if (isTurned[at(EditableSurface::faceOf(e))] != 0 && stays[at(surface.from(e))] == 0)
      {
        const Index v = surface.from(e);
        stays[at(v)] = 1;
        surface.setPoint(v, before[at(v)]);
        ++found;
      }
    }
    count += found;
  }
  return count;
}

} // namespace evolving
