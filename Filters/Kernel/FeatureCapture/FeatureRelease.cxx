// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCapture/FeatureRelease.h"

#include "FeatureCapture/FeatureReference.h"
#include "Mesh/Angles.h"
#include "Remeshing/FaceShape.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evolving
{

namespace
{

constexpr double Unbounded = std::numeric_limits<double>::infinity();

double angleAt(const EditableSurface& surface, Index e)
{
  const Vec3& point = surface.point(surface.from(e));
  return angleBetween(surface.point(surface.to(e)) - point, surface.point(surface.apex(e)) - point);
}

/// All that is around a pinned vertex where it is less than at a corner of a regular tetrahedron;
/// else infinite.
double angleOfTip(const EditableSurface& surface, Index v)
{
  double around = 0.0;
  surface.forEachOutgoing(v, [&](Index e) { around += angleAt(surface, e); });
  return surface.isPinned(v) && around < Pi ? around : Unbounded;
}

bool hasTip(const EditableSurface& surface, Index face)
{
  return angleOfTip(surface, surface.from(3 * face)) < Pi ||
    angleOfTip(surface, surface.from(3 * face + 1)) < Pi ||
    angleOfTip(surface, surface.from(3 * face + 2)) < Pi;
}

/// The edge of a face that begins where its angle is smallest.
Index sharpestCorner(const EditableSurface& surface, Index face)
{
  Index sharpest = 3 * face;
  for (Index e = 3 * face + 1; e < 3 * face + 3; ++e)
  {
    sharpest = angleAt(surface, e) < angleAt(surface, sharpest) ? e : sharpest;
  }
  return sharpest;
}

/// Two creases meet at its smallest angle: other triangles could not have a larger one there.
bool fillsCorner(const EditableSurface& surface, Index face)
{
  const Index a = sharpestCorner(surface, face);
  return surface.isPinned(surface.from(a)) && surface.curve(a) != NoIndex &&
    surface.curve(EditableSurface::previous(a)) != NoIndex;
}

/// The edges of the crease that is to go first at a face; none where there is no crease.
std::vector<Index> weakestAt(const EditableSurface& surface, Index face, const CreaseWorth& worth)
{
  const Index a = sharpestCorner(surface, face);
  const Index b = EditableSurface::previous(a);
  if (surface.curve(a) != NoIndex && surface.curve(b) != NoIndex)
  {
    return { worth.foldOf(surface.curve(a)) < worth.foldOf(surface.curve(b)) ? a : b };
  }
  std::vector<Index> weakest;
  double least = Unbounded;
  for (Index corner = 3 * face; corner < 3 * face + 3; ++corner)
  {
    surface.forEachOutgoing(surface.from(corner),
      [&](Index e)
      {
        const double fold =
          surface.curve(e) == NoIndex ? Unbounded : worth.foldOf(surface.curve(e));
        if (fold < least)
        {
          least = fold;
          weakest.clear();
        }
        if (fold < Unbounded && fold == least)
        {
          weakest.push_back(e);
        }
      });
  }
  return weakest;
}

bool isAtCrease(const EditableSurface& surface, Index face)
{
  return surface.featureEdges(surface.from(3 * face)) > 0 ||
    surface.featureEdges(surface.from(3 * face + 1)) > 0 ||
    surface.featureEdges(surface.from(3 * face + 2)) > 0;
}

/// The faces from an edge on, once around its beginning, up to the next crease or the boundary.
template <class Turn>
void forgetPatches(EditableSurface& surface, Index edge, const Turn& turn)
{
  Index e = edge;
  do
  {
    surface.setLabel(EditableSurface::faceOf(e), FeatureReference::NoPatch);
    e = turn(e);
  } while (e != NoIndex && e != edge);
}

/// The faces that an edge which is no crease any more has joined to each other, at its beginning.
void forgetPatchesAt(EditableSurface& surface, Index edge)
{
  forgetPatches(surface, edge,
    [&](Index e)
    {
      const Index last = EditableSurface::previous(e);
      return surface.isFeature(last) ? NoIndex : surface.opposite(last);
    });
  forgetPatches(surface, edge,
    [&](Index e)
    { return surface.isFeature(e) ? NoIndex : EditableSurface::next(surface.opposite(e)); });
}

/// Three triangles around a tip have angles that are worth it.
bool mayKeepTip(const EditableSurface& surface, Index v, const CreaseWorth& worth)
{
  const double around = angleOfTip(surface, v);
  return around < Pi && around >= 3.0 * worth.atTips * RadiansPerDegree;
}

void releaseEdge(EditableSurface& surface, Index e, const CreaseWorth& worth)
{
  surface.setCurve(e, NoIndex);
  for (const Index half : { e, surface.opposite(e) })
  {
    if (half != NoIndex)
    {
      forgetPatchesAt(surface, half);
      const Index v = surface.from(half);
      if (surface.featureEdges(v) == 0 && !mayKeepTip(surface, v, worth))
      {
        surface.releasePin(v);
      }
    }
  }
}

} // namespace

std::vector<Index> crampedFaces(const EditableSurface& surface, const CreaseWorth& worth)
{
  const double limit = std::cos(worth.angle * RadiansPerDegree);
  const double limitAtTips = std::cos(std::min(worth.angle, worth.atTips) * RadiansPerDegree);
  std::vector<Index> faces;
  for (Index f = 0; f < surface.faceSlots(); ++f)
  {
    const double cosine = surface.hasFace(f) ? cosineOfSmallestAngle(surface, f) : 0.0;
    if (cosine > limit && isAtCrease(surface, f) &&
      (cosine > limitAtTips || !(hasTip(surface, f) || fillsCorner(surface, f))))
    {
      faces.push_back(f);
    }
  }
  return faces;
}

std::vector<Index> creaseVertices(const EditableSurface& surface, const std::vector<Index>& faces)
{
  std::vector<Index> vertices;
  for (const Index f : faces)
  {
    for (Index e = 3 * f; e < 3 * f + 3; ++e)
    {
      if (surface.featureEdges(surface.from(e)) > 0)
      {
        vertices.push_back(surface.from(e));
      }
    }
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

void releaseWeakest(
  EditableSurface& surface, const std::vector<Index>& faces, const CreaseWorth& worth)
{
  std::vector<Index> weakest;
  for (const Index face : faces)
  {
    const std::vector<Index> edges = weakestAt(surface, face, worth);
    weakest.insert(weakest.end(), edges.begin(), edges.end());
  }
  for (const Index e : weakest)
  {
    releaseEdge(surface, e, worth);
  }
}

void releaseFeatures(
  EditableSurface& surface, const std::vector<Index>& vertices, const CreaseWorth& worth)
{
  for (const Index v : vertices)
  {
    if (!mayKeepTip(surface, v, worth))
    {
      surface.releasePin(v);
    }
    surface.forEachOutgoing(v,
      [&surface](Index e)
      {
        surface.setCurve(e, NoIndex);
        surface.setLabel(EditableSurface::faceOf(e), FeatureReference::NoPatch);
      });
  }
}

} // namespace evolving
