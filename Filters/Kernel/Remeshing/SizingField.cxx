// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/SizingField.h"

#include "Remeshing/VertexCurvature.h"

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

/// Of the logarithm of the error, over seven powers of ten: exact to 1e-11.
constexpr int Bisections = 40;
/// Of the largest size: with it edges reach that size where the radius is a million of them.
constexpr double LeastError = 1e-7;

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

double grownOver(const EditableSurface& surface, Index u, Index v, double gradation)
{
  return gradation * (surface.point(u) - surface.point(v)).norm();
}

/// For the size of a neighbour. Most are not, and what is not now can only become so by being
/// lowered.
bool isTooSmallBeside(const EditableSurface& surface, Index v, double gradation)
{
  bool isTooSmall = false;
  surface.forEachNeighbour(v,
    [&](Index u)
    {
      isTooSmall =
        isTooSmall || surface.size(u) > surface.size(v) + grownOver(surface, u, v, gradation);
    });
  return isTooSmall;
}

} // namespace

void gradeSizes(EditableSurface& surface, double gradation)
{
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    if (surface.hasVertex(v) && isTooSmallBeside(surface, v, gradation))
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
        const double most = size + grownOver(surface, u, v, gradation);
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
  const std::vector<double> curvatures = vertexCurvatures(surface);
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
  setSizes(surface, vertexCurvatures(surface), sizing, error);
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
