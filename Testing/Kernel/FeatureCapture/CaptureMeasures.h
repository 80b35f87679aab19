// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How well a surface has captured creases, by the triangles and edges of the target one by one.
 */

#ifndef EVOLVING_CAPTURE_MEASURES_H
#define EVOLVING_CAPTURE_MEASURES_H

#include "Features/TargetFeatures.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/EditingChecks.h"
#include "Trees/TriangleGeometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evolving::capture
{

/// In lengths of about 1.
constexpr double Rounding = 1e-12;

/// The squared distance of a point from a curve of the target.
inline double squaredDistanceToCurve(const TargetFeatures& features, Index curve, const Vec3& point)
{
  const TargetTriangles& target = features.target();
  double least = std::numeric_limits<double>::infinity();
  for (const Index edge : features.curves().curves()[static_cast<std::size_t>(curve)].edges)
  {
    const auto [a, b] = target.edgeVertices(edge);
    const Triangle segment{ { target.point(a), target.point(b), target.point(b) } };
    least = std::min(least, closestPointOnTriangle(point, segment).squaredDistance);
  }
  return least;
}

/// Of a point from a patch of the target.
inline double squaredDistanceToPatch(const TargetFeatures& features, Index patch, const Vec3& point)
{
  const SurfaceMesh& target = features.target().mesh();
  double least = std::numeric_limits<double>::infinity();
  for (Index t = 0; t < target.faceCount(); ++t)
  {
    if (features.patchOf(t) == patch)
    {
      least = std::min(least, closestPointOnTriangle(point, triangleOf(target, t)).squaredDistance);
    }
  }
  return least;
}

/// The largest distance of the ends of an edge on a crease, or of its middle, from that crease.
inline double farthestFromCreases(
  const EditableSurface& surface, const TargetFeatures& features, bool middles)
{
  double squared = 0.0;
  for (const Index e : editing::edgesOf(surface))
  {
    if (surface.curve(e) != NoIndex)
    {
      const Vec3& from = surface.point(surface.from(e));
      const Vec3 place = middles ? Vec3(0.5 * (from + surface.point(surface.to(e)))) : from;
      squared = std::max(squared, squaredDistanceToCurve(features, surface.curve(e), place));
    }
  }
  return std::sqrt(squared);
}

inline double captureLength(const EditableSurface& surface)
{
  double length = 0.0;
  for (const Index e : editing::edgesOf(surface))
  {
    length += surface.curve(e) != NoIndex ? 0.5 * surface.length(e) : 0.0;
  }
  return length;
}

inline Vec3 centroid(const EditableSurface& surface, Index f)
{
  return (surface.corner(f, 0) + surface.corner(f, 1) + surface.corner(f, 2)) / 3.0;
}

/// Pinned vertices at a point.
inline int pinsAt(const EditableSurface& surface, const Vec3& point)
{
  int pins = 0;
  for (const Index v : editing::verticesOf(surface))
  {
    pins += surface.isPinned(v) && surface.point(v) == point ? 1 : 0;
  }
  return pins;
}

inline int countPins(const EditableSurface& surface)
{
  int pins = 0;
  for (const Index v : editing::verticesOf(surface))
  {
    pins += surface.isPinned(v) ? 1 : 0;
  }
  return pins;
}

} // namespace evolving::capture

#endif
