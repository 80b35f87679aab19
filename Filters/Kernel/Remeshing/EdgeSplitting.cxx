// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/EdgeSplitting.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace evolving
{

namespace
{

/// Each sweep halves what is too long: more are not needed for any ratio of sizes that occurs.
constexpr int MostSweeps = 20;

double relativeLength(const EditableSurface& surface, Index e)
{
  return surface.length(e) / surface.size(surface.from(e), surface.to(e));
}

bool touchesLockedFace(const EditableSurface& surface, Index e)
{
  const Index o = surface.opposite(e);
  return surface.isLockedFace(EditableSurface::faceOf(e)) ||
    (o != NoIndex && surface.isLockedFace(EditableSurface::faceOf(o)));
}

} // namespace

Index halveLongEdges(EditableSurface& surface, double ratio)
{
  std::vector<std::pair<double, Index>> edges;
  for (Index e = 0; e < surface.edgeSlots(); ++e)
  {
    if (surface.hasEdge(e) && surface.isFirstHalf(e) && !touchesLockedFace(surface, e) &&
      relativeLength(surface, e) > ratio)
    {
      edges.emplace_back(-relativeLength(surface, e), e);
    }
  }
  std::sort(edges.begin(), edges.end());
  Index splits = 0;
  for (const auto& [length, e] : edges)
  {
    // A split beside it may have given the number to a new edge.
    if (relativeLength(surface, e) > ratio)
    {
      surface.split(e, 0.5 * (surface.point(surface.from(e)) + surface.point(surface.to(e))));
      ++splits;
    }
  }
  return splits;
}

Index splitLongEdges(EditableSurface& surface, double ratio)
{
  Index splits = 0;
  for (int sweep = 0; sweep < MostSweeps; ++sweep)
  {
    const Index halved = halveLongEdges(surface, ratio);
    if (halved == 0)
    {
      break;
    }
    splits += halved;
  }
  return splits;
}

} // namespace evolving
