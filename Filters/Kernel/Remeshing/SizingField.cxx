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

/// Of each vertex the largest curvature of an edge from it, seen from both ends' normals.
std::vector<double> largestEdgeCurvatures(const EditableSurface& surface)
{
  std::vector<Vec3> normals(at(surface.vertexSlots()));
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    normals[at(v)] = surface.hasVertex(v) ? surface.normal(v) : Vec3(Vec3::Zero());
  }
  std::vector<double> curvatures(at(surface.vertexSlots()), 0.0);
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    if (surface.hasVertex(v))
    {
      surface.forEachNeighbour(v,
        [&](Index u)
        {
          const Vec3 edge = surface.point(u) - surface.point(v);
          const double turn = (normals[at(u)] - normals[at(v)]).dot(edge);
          double& curvature = curvatures[at(v)];
          curvature = std::max(curvature, std::abs(turn) / edge.squaredNorm());
        });
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

void setSizes(EditableSurface& surface, const std::vector<double>& curvatures,
  const CurvatureSizing& sizing, double error)
{
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    const double k = curvatures[at(v)];
    const double squared = k > 0.0 ? 6.0 * error / k - 3.0 * error * error : HUGE_VAL;
    surface.setSize(
      v, std::clamp(std::sqrt(std::max(0.0, squared)), sizing.smallest, sizing.largest));
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
  double low = 1e-6 * sizing.smallest;
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
