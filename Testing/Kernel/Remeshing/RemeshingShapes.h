// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Surfaces with sizes to remesh, and how good their elements are.
 */

#ifndef EVOLVING_REMESHING_SHAPES_H
#define EVOLVING_REMESHING_SHAPES_H

#include "Mesh/SurfaceMesh.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/ReferenceSurface.h"
#include "Remeshing/SizingField.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evolving::shapes
{

/// A surface with the same size everywhere.
inline EditableSurface sized(const SurfaceMesh& mesh, double size)
{
  EditableSurface surface(mesh);
  setUniformSizes(surface, size);
  return surface;
}

/// The edge's length over the mean size of its ends.
inline double relativeLength(const EditableSurface& surface, Index e)
{
  return surface.length(e) / surface.size(surface.from(e), surface.to(e));
}

struct LengthRange
{
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0.0;
};

/// Of all edges, in sizes.
inline LengthRange relativeLengths(const EditableSurface& surface)
{
  LengthRange range;
  for (Index e = 0; e < surface.edgeSlots(); ++e)
  {
    if (surface.hasEdge(e))
    {
      range.shortest = std::min(range.shortest, relativeLength(surface, e));
      range.longest = std::max(range.longest, relativeLength(surface, e));
    }
  }
  return range;
}

/// The vertex that is nearest to a point.
inline Index vertexNear(const EditableSurface& surface, const Vec3& point)
{
  Index nearest = NoIndex;
  double least = std::numeric_limits<double>::infinity();
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    const double distance = (surface.point(v) - point).norm();
    if (surface.hasVertex(v) && distance < least)
    {
      least = distance;
      nearest = v;
    }
  }
  return nearest;
}

/// The unit sphere itself.
class ExactSphere : public ReferenceSurface
{
public:
  Foot onSurface(
    const Vec3& point, const Vec3& /*facing*/, Index /*label*/, Index /*guess*/) const override
  {
    return { point.normalized(), point.normalized(), NoIndex };
  }
};

/// Makes every edge whose faces' normals differ by more than 60 degrees part of curve 0.
inline void markCreases(EditableSurface& surface)
{
  for (Index e = 0; e < surface.edgeSlots(); ++e)
  {
    if (surface.hasEdge(e) && surface.opposite(e) != NoIndex)
    {
      const Vec3 one = surface.doubleArea(e / 3).normalized();
      const Vec3 other = surface.doubleArea(surface.opposite(e) / 3).normalized();
      if (one.dot(other) < 0.5)
      {
        surface.setCurve(e, 0);
      }
    }
  }
}

} // namespace evolving::shapes

#endif
