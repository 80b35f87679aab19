// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/Relaxation.h"

#include "ParallelLoops.h"
#include "Remeshing/InversionFreeMove.h"

#include <vector>

namespace evolving
{

namespace
{

/// The mean of the centroids of the faces around a vertex. A face weighs as much as the number of
/// elements of the wanted size that fit into it.
Vec3 weightedCentroid(const EditableSurface& surface, Index v)
{
  Vec3 sum = Vec3::Zero();
  double weights = 0.0;
  surface.forEachOutgoing(v,
    [&](Index e)
    {
      const Index f = EditableSurface::faceOf(e);
      const Index b = surface.to(e);
      const Index c = surface.apex(e);
      const double size = (surface.size(v) + surface.size(b) + surface.size(c)) / 3.0;
      const double weight = surface.doubleArea(f).norm() / (size * size);
      sum += weight / 3.0 * (surface.point(v) + surface.point(b) + surface.point(c));
      weights += weight;
    });
  return weights > 0.0 ? Vec3(sum / weights) : surface.point(v);
}

/// Between the neighbours on the curve, nearer to the one where elements are smaller.
Vec3 middleOnCurve(const EditableSurface& surface, Index v)
{
  Vec3 sum = Vec3::Zero();
  double weights = 0.0;
  surface.forEachOutgoing(v,
    [&](Index e)
    {
      if (surface.isFeature(e))
      {
        const double weight = surface.length(e) / surface.size(v, surface.to(e));
        sum += weight * 0.5 * (surface.point(v) + surface.point(surface.to(e)));
        weights += weight;
      }
    });
  return weights > 0.0 ? Vec3(sum / weights) : surface.point(v);
}

/// Where a vertex belongs on the reference, seen from a point near by.
Vec3 placed(EditableSurface& surface, const ReferenceSurface& reference, Index v, const Vec3& point,
  const Vec3& normal)
{
  Index label = 0;
  surface.forEachOutgoing(v, [&](Index e) { label = surface.label(EditableSurface::faceOf(e)); });
  const ReferenceSurface::Foot foot = reference.onSurface(point, normal, label, surface.guess(v));
  surface.setGuess(v, foot.triangle);
  return foot.point;
}

Vec3 relaxed(EditableSurface& surface, const ReferenceSurface& reference, Index v, double damping)
{
  if (!surface.hasVertex(v) || surface.isPinned(v))
  {
    return surface.point(v);
  }
  const Vec3& point = surface.point(v);
  if (surface.featureEdges(v) == 0)
  {
    const Vec3 normal = surface.normal(v);
    const Vec3 move =
      damping > 0.0 ? Vec3(damping * (weightedCentroid(surface, v) - point)) : Vec3(Vec3::Zero());
    return placed(surface, reference, v, point + move - move.dot(normal) * normal, normal);
  }
  const Index curve = curveOfVertex(surface, v);
  if (curve == NoIndex)
  {
    return point;
  }
  const Vec3 move =
    damping > 0.0 ? Vec3(damping * (middleOnCurve(surface, v) - point)) : Vec3(Vec3::Zero());
  return reference.onCurve(point + move, curve);
}

} // namespace

Index curveOfVertex(const EditableSurface& surface, Index vertex)
{
  Index curve = NoIndex;
  Index edges = 0;
  bool isOne = true;
  surface.forEachOutgoing(vertex,
    [&](Index e)
    {
      if (surface.isFeature(e))
      {
        isOne = isOne && (edges == 0 || surface.curve(e) == curve);
        curve = surface.curve(e);
        ++edges;
      }
    });
  return isOne && edges == 2 && surface.featureEdges(vertex) == 2 ? curve : NoIndex;
}

void relax(EditableSurface& surface, const ReferenceSurface& reference, double damping, int sweeps,
  const Execution& execution)
{
  std::vector<Vec3> points;
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    points.resize(at(surface.vertexSlots()));
    execution.forRange(surface.vertexSlots(), Execution::MeshGrain,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (Index v = static_cast<Index>(begin); v < static_cast<Index>(end); ++v)
        {
          points[at(v)] = relaxed(surface, reference, v, damping);
        }
      });
    moveWithoutInversion(surface, points, execution);
  }
}

void land(EditableSurface& surface, const ReferenceSurface& reference, const Execution& execution)
{
  landWhere(
    surface, reference, [](const Vec3&) { return true; }, execution);
}

void landWhere(EditableSurface& surface, const ReferenceSurface& reference,
  const std::function<bool(const Vec3&)>& isWanted, const Execution& execution)
{
  std::vector<Vec3> points(at(surface.vertexSlots()));
  execution.forRange(surface.vertexSlots(), Execution::MeshGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (Index v = static_cast<Index>(begin); v < static_cast<Index>(end); ++v)
      {
        points[at(v)] =
          isWanted(surface.point(v)) ? relaxed(surface, reference, v, 0.0) : surface.point(v);
      }
    });
  moveWithoutInversion(surface, points, execution);
}

} // namespace evolving
