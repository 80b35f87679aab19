// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCapture/FeatureRelease.h"

#include "FeatureCapture/FeatureReference.h"
#include "Mesh/Angles.h"
#include "Remeshing/FaceShape.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// More pointed than a corner of a regular tetrahedron.
bool isTip(const EditableSurface& surface, Index v)
{
  double around = 0.0;
  surface.forEachOutgoing(v,
    [&](Index e)
    {
      const Vec3& tip = surface.point(v);
      const Index next = EditableSurface::next(e);
      around +=
        angleBetween(surface.point(surface.to(e)) - tip, surface.point(surface.to(next)) - tip);
    });
  return surface.isPinned(v) && around < Pi;
}

bool hasTip(const EditableSurface& surface, Index face)
{
  return isTip(surface, surface.from(3 * face)) || isTip(surface, surface.from(3 * face + 1)) ||
    isTip(surface, surface.from(3 * face + 2));
}

} // namespace

std::vector<Index> crampedFeatures(const EditableSurface& surface, double degrees, double atTips)
{
  const double limit = std::cos(degrees * RadiansPerDegree);
  const double limitAtTips = std::cos(std::min(degrees, atTips) * RadiansPerDegree);
  const auto isCramped = [&](Index face)
  {
    const double cosine = cosineOfSmallestAngle(surface, face);
    return cosine > limit && (cosine > limitAtTips || !hasTip(surface, face));
  };
  std::vector<Index> vertices;
  for (Index e = 0; e < surface.edgeSlots(); ++e)
  {
    if (surface.hasEdge(e) && surface.featureEdges(surface.from(e)) > 0 &&
      isCramped(EditableSurface::faceOf(e)))
    {
      vertices.push_back(surface.from(e));
    }
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

void releaseFeatures(EditableSurface& surface, const std::vector<Index>& vertices)
{
  for (const Index v : vertices)
  {
    surface.releasePin(v);
    surface.forEachOutgoing(v,
      [&surface](Index e)
      {
        surface.setCurve(e, NoIndex);
        surface.setLabel(EditableSurface::faceOf(e), FeatureReference::NoPatch);
      });
  }
}

} // namespace evolving
