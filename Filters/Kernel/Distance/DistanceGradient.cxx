// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/DistanceGradient.h"

#include "Distance/ClosestTriangles.h"
#include "Distance/Signs/Pseudonormals.h"
#include "Trees/TriangleGeometry.h"

#include <algorithm>
#include <optional>

namespace evolving
{

std::vector<float> normalizedDifferences(
  const DistanceGrid& grid, const std::vector<float>& values, const Execution& execution)
{
  std::vector<float> gradient(3 * values.size());
  const auto difference = [&](GridIndex sample, int place, int axis, GridIndex stride)
  {
    const int before = place > 0 ? 1 : 0;
    const int after = place + 1 < grid.dimension(axis) ? 1 : 0;
    const auto value = [&](GridIndex s) { return double(values[static_cast<std::size_t>(s)]); };
    const double change = value(sample + after * stride) - value(sample - before * stride);
    return change / (std::max(1, before + after) * grid.spacing[axis]);
  };
  const int width = grid.dimension(0);
  const int height = grid.dimension(1);
  constexpr std::int64_t RowGrain = 64;
  execution.forRangeReporting(std::int64_t(height) * grid.dimension(2), RowGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (GridIndex sample = begin * width; sample < end * width; ++sample)
      {
        const GridIndex row = sample / width;
        const Vec3 slope(difference(sample, static_cast<int>(sample % width), 0, 1),
          difference(sample, static_cast<int>(row % height), 1, width),
          difference(sample, static_cast<int>(row / height), 2, GridIndex(width) * height));
        const double length = slope.norm();
        for (int axis = 0; axis < 3 && length > 0.0; ++axis)
        {
          gradient[static_cast<std::size_t>(3 * sample + axis)] =
            static_cast<float>(slope[axis] / length);
        }
      }
    });
  return gradient;
}

std::vector<float> awayFromClosest(const DistanceTarget& target, const DistanceGrid& grid,
  const std::vector<Index>& triangles, const std::vector<char>& inside, bool isSigned,
  const Execution& execution)
{
  std::vector<float> gradient(3 * triangles.size());
  const SurfaceMesh& mesh = target.mesh;
  std::optional<Pseudonormals> normals;
  if (isSigned)
  {
    normals.emplace(mesh, target.orientation.edgeOfCorner);
  }
  const double tooClose = 1e-6 * grid.spacing.minCoeff();
  forEachSample(grid, execution,
    [&](GridIndex sample, const Vec3& point)
    {
      const auto s = static_cast<std::size_t>(sample);
      const TrianglePoint closest = closestPointOnTriangle(point, triangleOf(mesh, triangles[s]));
      Vec3 direction = inside[s] ? Vec3(closest.point - point) : Vec3(point - closest.point);
      if (direction.norm() <= tooClose)
      {
        direction = isSigned ? normals->at(triangles[s], closest.feature) : Vec3(Vec3::Zero());
      }
      const double length = direction.norm();
      direction = length > 0.0 ? Vec3(direction / length) : direction;
      Eigen::Map<Eigen::Vector3f>(gradient.data() + 3 * sample) = direction.cast<float>();
    });
  return gradient;
}

} // namespace evolving
