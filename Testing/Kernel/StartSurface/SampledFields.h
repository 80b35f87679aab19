// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Grids and sampled functions for the tests of this folder.
 */

#ifndef EVOLVING_TESTING_SAMPLED_FIELDS_H
#define EVOLVING_TESTING_SAMPLED_FIELDS_H

#include "Distance/DistanceGrid.h"
#include "SampledOnGrid.h"

#include <cmath>
#include <random>
#include <vector>

namespace evolving
{
namespace testing_fields
{

/// n samples a side over [-1, 1]^3.
inline DistanceGrid unitGrid(int n)
{
  DistanceGrid grid;
  grid.origin = Vec3::Constant(-1.0);
  grid.spacing = Vec3::Constant(2.0 / (n - 1));
  grid.extent = { 0, n - 1, 0, n - 1, 0, n - 1 };
  return grid;
}

using evolving::sampled;

/// Independent values, evenly distributed in [0, 1).
inline std::vector<float> noise(const DistanceGrid& grid, unsigned seed)
{
  std::mt19937 random(seed);
  return sampled(grid, [&](const Vec3&) { return static_cast<double>(random()) / 4294967296.0; });
}

inline double torusDistance(const Vec3& p, double ringRadius, double tubeRadius)
{
  return std::hypot(std::hypot(p.x(), p.y()) - ringRadius, p.z()) - tubeRadius;
}

} // namespace testing_fields
} // namespace evolving

#endif
