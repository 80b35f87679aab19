// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/VertexCurvature.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// Curvatures of edges scatter by the quality of triangles; more averages than this smooth away
/// what elements can follow.
constexpr int Averages = 2;

bool isOnCrease(const EditableSurface& surface, Index e)
{
  return surface.curve(e) != NoIndex;
}

/// The edges that leave a vertex, counter-clockwise, from one on a crease if there is any.
std::vector<Index> fanFromCrease(const EditableSurface& surface, Index v)
{
  std::vector<Index> fan;
  surface.forEachOutgoing(v, [&](Index e) { fan.push_back(e); });
  const auto crease =
    std::find_if(fan.begin(), fan.end(), [&](Index e) { return isOnCrease(surface, e); });
  if (crease != fan.end() && !surface.isBoundary(v))
  {
    std::rotate(fan.begin(), crease, fan.end());
  }
  return fan;
}

/// For each half-edge the normal where it begins, of the faces there up to the next creases.
std::vector<Vec3> normalsBesideCreases(const EditableSurface& surface)
{
  std::vector<Vec3> normals(at(surface.edgeSlots()), Vec3::Zero());
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    const std::vector<Index> fan =
      surface.hasVertex(v) ? fanFromCrease(surface, v) : std::vector<Index>();
    for (auto first = fan.begin(); first != fan.end();)
    {
      const auto last =
        std::find_if(first + 1, fan.end(), [&](Index e) { return isOnCrease(surface, e); });
      Vec3 sum = Vec3::Zero();
      std::for_each(
        first, last, [&](Index e) { sum += surface.doubleArea(EditableSurface::faceOf(e)); });
      const Vec3 normal = sum.stableNormalized();
      std::for_each(first, last, [&](Index e) { normals[at(e)] = normal; });
      first = last;
    }
  }
  return normals;
}

/**
 * Of each vertex the largest curvature of an edge at it, seen from both ends' normals; what folds
 * at a crease does not count.
 */
std::vector<double> largestEdgeCurvatures(const EditableSurface& surface)
{
  const std::vector<Vec3> normals = normalsBesideCreases(surface);
  std::vector<double> curvatures(at(surface.vertexSlots()), 0.0);
  for (Index e = 0; e < surface.edgeSlots(); ++e)
  {
    if (surface.hasEdge(e))
    {
      const Vec3 edge = surface.point(surface.to(e)) - surface.point(surface.from(e));
      const double turn = (normals[at(EditableSurface::next(e))] - normals[at(e)]).dot(edge);
      const double curvature = std::abs(turn) / edge.squaredNorm();
      for (const Index v : { surface.from(e), surface.to(e) })
      {
        curvatures[at(v)] = std::max(curvatures[at(v)], curvature);
      }
    }
  }
  return curvatures;
}

void averageOverRings(const EditableSurface& surface, std::vector<double>& values)
{
  const std::vector<double> old = values;
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    if (surface.hasVertex(v))
    {
      double sum = old[at(v)];
      double count = 1.0;
      surface.forEachNeighbour(v,
        [&](Index u)
        {
          sum += old[at(u)];
          count += 1.0;
        });
      values[at(v)] = sum / count;
    }
  }
}

} // namespace

std::vector<double> vertexCurvatures(const EditableSurface& surface)
{
  std::vector<double> curvatures = largestEdgeCurvatures(surface);
  for (int i = 0; i < Averages; ++i)
  {
    averageOverRings(surface, curvatures);
  }
  return curvatures;
}

} // namespace evolving
