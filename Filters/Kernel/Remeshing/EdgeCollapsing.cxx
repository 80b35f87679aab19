// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/EdgeCollapsing.h"

#include "Remeshing/FaceShape.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace evolving
{

namespace
{

constexpr int MostSweeps = 20;

/// Who may move where when an edge becomes a point.
enum class Mobility
{
  Free = 0,
  AlongCurve = 1,
  None = 2,
};

Mobility mobilityOf(const EditableSurface& surface, Index v)
{
  const Index curves = surface.featureEdges(v);
  if (surface.isPinned(v) || (curves != 0 && curves != 2))
  {
    return Mobility::None;
  }
  return curves == 0 ? Mobility::Free : Mobility::AlongCurve;
}

/// Judges the faces that a vertex takes along when it moves.
class CollapseJudge
{
public:
  CollapseJudge(const EditableSurface& surface, const CollapseGuards& guards)
    : Surface(surface)
    , Guards(guards)
  {
  }

  /// May `e` become `point`? @return what the guards say of both ends' faces
  bool accepts(Index e, const Vec3& point) const
  {
    const Index a = this->Surface.from(e);
    const Index b = this->Surface.to(e);
    double worstBefore = 1.0;
    double worstAfter = 1.0;
    bool isGood = true;
    for (const Index v : { a, b })
    {
      const Index other = v == a ? b : a;
      this->Surface.forEachOutgoing(v,
        [&](Index out)
        { isGood = isGood && this->judge(out, other, point, worstBefore, worstAfter); });
      this->Surface.forEachNeighbour(v,
        [&](Index u) { isGood = isGood && (u == other || this->isShortEnough(u, other, point)); });
    }
    return isGood && (worstAfter >= this->Guards.leastQuality || worstAfter > worstBefore);
  }

private:
  bool isShortEnough(Index u, Index kept, const Vec3& point) const
  {
    return (this->Surface.point(u) - point).norm() <
      this->Guards.longest * this->Surface.size(u, kept);
  }

  /// The face of an edge that leaves the vertex; `other` is the edge's other end.
  bool judge(Index out, Index other, const Vec3& point, double& before, double& after) const
  {
    const Index u = this->Surface.to(out);
    const Index w = this->Surface.apex(out);
    const Vec3& p = this->Surface.point(u);
    const Vec3& q = this->Surface.point(w);
    const Vec3& old = this->Surface.point(this->Surface.from(out));
    before = std::min(before, faceShape(old, p, q));
    if (u == other || w == other)
    {
      return true;
    }
    const Vec3 normal = (p - point).cross(q - point);
    const Vec3 oldNormal = (p - old).cross(q - old);
    after = std::min(after, faceShape(point, p, q));
    return normal.dot(oldNormal) >= this->Guards.leastCosine * normal.norm() * oldNormal.norm();
  }

  const EditableSurface& Surface;
  const CollapseGuards& Guards;
};

/// Collapses e if it may; the half-edge to take and the point follow from who may move.
bool tryCollapse(EditableSurface& surface, Index e, const CollapseGuards& guards)
{
  const Mobility from = mobilityOf(surface, surface.from(e));
  const Mobility to = mobilityOf(surface, surface.to(e));
  const bool isAlongCurve = surface.isFeature(e);
  const auto mayVanish = [&](Mobility m)
  { return m == Mobility::Free || (m == Mobility::AlongCurve && isAlongCurve); };
  if (from == Mobility::Free && to == Mobility::Free)
  {
    const Vec3 middle = 0.5 * (surface.point(surface.from(e)) + surface.point(surface.to(e)));
    if (surface.canCollapse(e) && CollapseJudge(surface, guards).accepts(e, middle))
    {
      const Index kept = surface.to(e);
      surface.collapse(e);
      surface.setPoint(kept, middle);
      return true;
    }
  }
  const CollapseJudge judge(surface, guards);
  const auto tryInto = [&](Index half)
  {
    if (!surface.canCollapse(half) || !judge.accepts(half, surface.point(surface.to(half))))
    {
      return false;
    }
    surface.collapse(half);
    return true;
  };
  // The vertex that is less free stays.
  const Index o = surface.opposite(e);
  const bool fromFirst = from <= to;
  if (mayVanish(from) && fromFirst && tryInto(e))
  {
    return true;
  }
  if (o != NoIndex && mayVanish(to) && to <= from && tryInto(o))
  {
    return true;
  }
  return false;
}

} // namespace

bool collapseEdge(EditableSurface& surface, Index edge, const CollapseGuards& guards)
{
  return tryCollapse(surface, edge, guards);
}

Index collapseShortEdges(EditableSurface& surface, double ratio, const CollapseGuards& guards)
{
  const auto relativeLength = [&surface](Index e)
  { return surface.length(e) / surface.size(surface.from(e), surface.to(e)); };
  Index collapses = 0;
  std::vector<std::pair<double, Index>> edges;
  for (int sweep = 0; sweep < MostSweeps; ++sweep)
  {
    edges.clear();
    for (Index e = 0; e < surface.edgeSlots(); ++e)
    {
      if (surface.hasEdge(e) && surface.isFirstHalf(e) && relativeLength(e) < ratio)
      {
        edges.emplace_back(relativeLength(e), e);
      }
    }
    std::sort(edges.begin(), edges.end());
    Index done = 0;
    for (const auto& [length, e] : edges)
    {
      if (surface.hasEdge(e) && relativeLength(e) < ratio && tryCollapse(surface, e, guards))
      {
        ++done;
      }
    }
    collapses += done;
    if (done == 0)
    {
      break;
    }
  }
  return collapses;
}

Index collapseLowValences(EditableSurface& surface, const CollapseGuards& guards)
{
  Index collapses = 0;
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    if (!surface.hasVertex(v) || surface.valence(v) > 4 || mobilityOf(surface, v) != Mobility::Free)
    {
      continue;
    }
    std::vector<std::pair<double, Index>> edges;
    surface.forEachOutgoing(v, [&](Index e) { edges.emplace_back(surface.length(e), e); });
    std::sort(edges.begin(), edges.end());
    for (const auto& [length, e] : edges)
    {
      if (surface.canCollapse(e) &&
        CollapseJudge(surface, guards).accepts(e, surface.point(surface.to(e))))
      {
        surface.collapse(e);
        ++collapses;
        break;
      }
    }
  }
  return collapses;
}

} // namespace evolving
