// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Grids, and functions sampled on them.
 */

#ifndef EVOLVING_TESTING_SAMPLED_ON_GRID_H
#define EVOLVING_TESTING_SAMPLED_ON_GRID_H

#include "Distance/DistanceGrid.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace evolving::shapes
{

/// n samples along each axis over [-half, half]^3 about a centre.
inline DistanceGrid cubicGrid(int n, double half = 1.0, const Vec3& centre = Vec3::Zero())
{
  DistanceGrid grid;
  grid.origin = centre - Vec3::Constant(half);
  grid.spacing = Vec3::Constant(2.0 * half / (n - 1));
  grid.extent = { 0, n - 1, 0, n - 1, 0, n - 1 };
  return grid;
}

/// A function's values, x fastest, as images have them.
template <typename Function>
std::vector<float> sampled(const DistanceGrid& grid, const Function& function)
{
  std::vector<float> values;
  const Extent& e = grid.extent;
  for (int k = e[4]; k <= e[5]; ++k)
  {
    for (int j = e[2]; j <= e[3]; ++j)
    {
      for (int i = e[0]; i <= e[1]; ++i)
      {
        const Vec3 point = grid.origin + Vec3(i, j, k).cwiseProduct(grid.spacing);
        values.push_back(static_cast<float>(function(point)));
      }
    }
  }
  return values;
}

/// Independent values, evenly distributed in [0, 1).
inline std::vector<float> noise(const DistanceGrid& grid, unsigned seed)
{
  std::mt19937 random(seed);
  return sampled(grid, [&](const Vec3&) { return static_cast<double>(random()) / 4294967296.0; });
}

/// Signed, from a box about the origin.
inline double boxDistance(const Vec3& p, const Vec3& halfSides)
{
  const Vec3 beyond = p.cwiseAbs() - halfSides;
  return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
}

/// Signed, from a torus around z.
inline double torusDistance(const Vec3& p, double ringRadius, double tubeRadius)
{
  return std::hypot(std::hypot(p.x(), p.y()) - ringRadius, p.z()) - tubeRadius;
}

} // namespace evolving::shapes

#endif
