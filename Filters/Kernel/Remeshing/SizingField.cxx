// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/SizingField.h"

#include "ParallelLoops.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace evolving
{

namespace
{

constexpr int Averages = 2;
constexpr int Bisections = 40;
/// Of the largest size: with it edges reach that size where the radius is a million of them.
constexpr double LeastError = 1e-7;

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

double sizeFor(double curvature, double error)
{
  if (curvature <= 0.0)
  {
    return HUGE_VAL;
  }
  // No triangle between points of a sphere is farther from it than the radius.
  const double e = std::min(error, 1.0 / curvature);
  return std::sqrt(6.0 * e / curvature - 3.0 * e * e);
}

void setSizes(EditableSurface& surface, const std::vector<double>& curvatures,
  const CurvatureSizing& sizing, double error)
{
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    surface.setSize(
      v, std::clamp(sizeFor(curvatures[at(v)], error), sizing.smallest, sizing.largest));
  }
  gradeSizes(surface, sizing.gradation);
}

std::vector<double> averagedCurvatures(const EditableSurface& surface)
{
  std::vector<double> curvatures = largestEdgeCurvatures(surface);
  for (int i = 0; i < Averages; ++i)
  {
    averageOverRings(surface, curvatures);
  }
  return curvatures;
}

} // namespace

void gradeSizes(EditableSurface& surface, double gradation)
{
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    if (surface.hasVertex(v))
    {
      queue.emplace(surface.size(v), v);
    }
  }
  while (!queue.empty())
  {
    const auto [size, v] = queue.top();
    queue.pop();
    if (size > surface.size(v))
    {
      continue; // lowered since
    }
    surface.forEachNeighbour(v,
      [&, size = size, v = v](Index u)
      {
        const double most = size + gradation * (surface.point(u) - surface.point(v)).norm();
        if (surface.size(u) > most)
        {
          surface.setSize(u, most);
          queue.emplace(most, u);
        }
      });
  }
}

void setUniformSizes(EditableSurface& surface, double size)
{
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    surface.setSize(v, size);
  }
}

double setSizesForVertexCount(
  EditableSurface& surface, const CurvatureSizing& sizing, double vertices)
{
  const std::vector<double> curvatures = averagedCurvatures(surface);
  // Between errors that clamp every size: more error, fewer vertices.
  double low = LeastError * sizing.largest;
  double high = sizing.largest;
  for (int i = 0; i < Bisections; ++i)
  {
    const double error = std::sqrt(low * high);
    setSizes(surface, curvatures, sizing, error);
    (expectedVertices(surface) > vertices ? low : high) = error;
  }
  return high;
}

void setSizesForError(EditableSurface& surface, const CurvatureSizing& sizing, double error)
{
  setSizes(surface, averagedCurvatures(surface), sizing, error);
}

double expectedVertices(const EditableSurface& surface)
{
  double vertices = 0.0;
  for (Index f = 0; f < surface.faceSlots(); ++f)
  {
    if (surface.hasFace(f))
    {
      const double size =
        (surface.size(surface.from(3 * f)) + surface.size(surface.from(3 * f + 1)) +
          surface.size(surface.from(3 * f + 2))) /
        3.0;
      // A vertex has two equilateral triangles of area sqrt(3)/4 s^2.
      vertices += surface.doubleArea(f).norm() / (std::sqrt(3.0) * size * size);
    }
  }
  return vertices;
}

} // namespace evolving
