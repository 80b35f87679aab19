// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/EdgeCollapsing.h"

#include "Remeshing/FailedCollapses.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace evolving
{

namespace
{

/// Each sweep makes what is too short up to twice as long: more are not needed for any ratio of
/// sizes that occurs.
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
  if (surface.isPinned(v))
  {
    return Mobility::None;
  }
  Index features = 0;
  Index curve = NoIndex;
  bool isOneCurve = true;
  const auto meet = [&](Index e)
  {
    if (surface.isFeature(e))
    {
      isOneCurve = isOneCurve && (features == 0 || surface.curve(e) == curve);
      curve = surface.curve(e);
      ++features;
    }
  };
  surface.forEachOutgoing(v,
    [&](Index e)
    {
      meet(e);
      const Index incoming = EditableSurface::previous(e);
      if (surface.opposite(incoming) == NoIndex)
      {
        meet(incoming);
      }
    });
  const bool isOnCurve = features == 2 && isOneCurve;
  return features == 0 ? Mobility::Free : (isOnCurve ? Mobility::AlongCurve : Mobility::None);
}

/// Collapses edges where they may; what is kept, and where, follows from who may move.
class Collapser
{
public:
  Collapser(EditableSurface& surface, const CollapseLimits& guards)
    : Surface(surface)
    , Criteria(surface, guards)
  {
  }

  bool tryEdge(Index e)
  {
    if (!this->Surface.canCollapse(e))
    {
      return false; // neither into one end nor into the other
    }
    const Mobility from = mobilityOf(this->Surface, this->Surface.from(e));
    const Mobility to = mobilityOf(this->Surface, this->Surface.to(e));
    const auto mayVanish = [&](Mobility m)
    { return m == Mobility::Free || (m == Mobility::AlongCurve && this->Surface.isFeature(e)); };
    if (from == Mobility::Free && to == Mobility::Free && this->tryMiddle(e))
    {
      return true;
    }
    // The vertex that is less free stays.
    if (from <= to && mayVanish(from) && this->tryInto(e))
    {
      return true;
    }
    const Index o = this->Surface.opposite(e);
    return to <= from && mayVanish(to) && (o != NoIndex ? this->tryInto(o) : this->tryOutOf(e));
  }

  bool tryFrom(Index e) { return this->Surface.canCollapse(e) && this->tryInto(e); }

private:
  bool tryInto(Index e)
  {
    const Index kept = this->Surface.to(e);
    if (!this->isWithinCut(e, this->Surface.from(e), kept) ||
      !this->Criteria.accepts(e, kept, this->Surface.point(kept)))
    {
      return false;
    }
    this->Surface.collapse(e);
    return true;
  }

  bool tryMiddle(Index e)
  {
    const Index kept = this->Surface.to(e);
    const Vec3 middle =
      0.5 * (this->Surface.point(this->Surface.from(e)) + this->Surface.point(kept));
    if (!this->Criteria.accepts(e, kept, middle))
    {
      return false;
    }
    this->Surface.collapse(e);
    this->Surface.setPoint(kept, middle);
    return true;
  }

  /// An edge of the boundary has one half-edge only: its far end takes over all of the near one.
  bool tryOutOf(Index e)
  {
    const Index kept = this->Surface.from(e);
    const Index heir = this->Surface.to(e);
    if (!this->isWithinCut(e, heir, kept) ||
      !this->Criteria.accepts(e, kept, this->Surface.point(kept)))
    {
      return false;
    }
    this->Surface.collapse(e);
    this->Surface.takeOver(heir, kept);
    return true;
  }

  bool isWithinCut(Index e, Index vanishing, Index kept) const
  {
    return this->Surface.opposite(e) != NoIndex || this->Criteria.mayCut(vanishing, kept);
  }

  EditableSurface& Surface;
  CollapseCriteria Criteria;
};

} // namespace

bool collapseEdge(EditableSurface& surface, Index edge, const CollapseLimits& guards)
{
  return Collapser(surface, guards).tryEdge(edge);
}

Index collapseShortEdges(EditableSurface& surface, double ratio, const CollapseLimits& guards)
{
  const auto relativeLength = [&surface](Index e)
  { return surface.length(e) / surface.size(surface.from(e), surface.to(e)); };
  Collapser collapser(surface, guards);
  FailedCollapses failed(surface);
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
      if (!surface.hasEdge(e) || relativeLength(e) >= ratio || failed.contain(e))
      {
        continue;
      }
      const Index from = surface.from(e);
      const Index to = surface.to(e);
      if (!collapser.tryEdge(e))
      {
        failed.add(e);
        continue;
      }
      failed.addCollapse(surface.hasVertex(to) ? to : from);
      ++done;
    }
    collapses += done;
    if (done == 0)
    {
      break;
    }
  }
  return collapses;
}

Index collapseLowValences(EditableSurface& surface, const CollapseLimits& guards)
{
  Collapser collapser(surface, guards);
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
    const bool isGone = std::any_of(edges.begin(), edges.end(),
      [&](const auto& entry) { return collapser.tryFrom(entry.second); });
    collapses += isGone ? 1 : 0;
  }
  return collapses;
}

} // namespace evolving
