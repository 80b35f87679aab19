// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Images as scanners make them, of objects with a known surface.
 */

#ifndef EVOLVING_NOISY_IMAGES_H
#define EVOLVING_NOISY_IMAGES_H

#include "Distance/DistanceGrid.h"
#include "Evolution/ScalarImage.h"
#include "Shapes/SampledOnGrid.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <random>
#include <vector>

namespace evolving::shapes
{

/// Hounsfield units of tissue and of air.
struct Intensities
{
  double inside = 60.0;
  double outside = -1000.0;
};

/// A grid of n^3 samples about the origin, at a distance of one, but for a shift off it.
inline DistanceGrid voxels(int n)
{
  DistanceGrid grid = cubicGrid(n, 0.5 * (n - 1));
  grid.origin += Vec3(0.3, -0.2, 0.1);
  return grid;
}

/**
 * @param distance from the object's surface, in voxels: a voxel that it cuts has a part of both
 * intensities
 * @param noise standard deviation of Gaussian noise, by the contrast
 */
inline std::shared_ptr<const ScalarImage> noisyImage(const DistanceGrid& grid,
  const std::function<double(const Vec3&)>& distance, double noise, Intensities i = {},
  unsigned seed = 1)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  return std::make_shared<const ScalarImage>(grid,
    sampled(grid,
      [&](const Vec3& p)
      {
        const double part = std::clamp(0.5 - distance(p) / grid.spacing.minCoeff(), 0.0, 1.0);
        return i.outside + (i.inside - i.outside) * (part + noise * normal(random));
      }));
}

inline std::function<double(const Vec3&)> ballOf(double radius)
{
  return [radius](const Vec3& p) { return p.norm() - radius; };
}

} // namespace evolving::shapes

#endif
