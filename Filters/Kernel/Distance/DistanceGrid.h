// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A regular grid of samples, as in an image: where it lies and how its samples are numbered.
 */

#ifndef EVOLVING_DISTANCE_GRID_H
#define EVOLVING_DISTANCE_GRID_H

#include "Types.h"

#include <array>

namespace evolving
{

/// Inclusive sample ranges { x0, x1, y0, y1, z0, z1 }, as VTK's extents.
using Extent = std::array<int, 6>;

/// Samples at origin + (i, j, k) * spacing for (i, j, k) in the extent; x runs fastest.
struct DistanceGrid
{
  Vec3 origin = Vec3::Zero();  ///< of sample (0, 0, 0), inside the extent or not
  Vec3 spacing = Vec3::Ones(); ///< between samples, positive
  Extent extent = { 0, -1, 0, -1, 0, -1 };

  int dimension(int axis) const;
  GridIndex sampleCount() const;
  /// The number of sample (i, j, k) in an array over the extent.
  GridIndex index(int i, int j, int k) const;
  Vec3 point(int i, int j, int k) const;
  /// Do the cells have equal sides (to rounding)? Axes of one sample have no cells and agree.
  bool isCubic() const;
  /// The grid restricted to a part of its extent.
  DistanceGrid part(const Extent& extent) const;
};

/**
 * The grid of `dimensions` samples over a box widened on every side by `padding` times its
 * longest side, and then symmetrically until cells are cubes. Every dimension at least 1. An axis
 * of one sample is sampled through the middle of the box.
 */
DistanceGrid gridAround(const Box& box, const std::array<int, 3>& dimensions, double padding);

/// The grid of `dimensions` samples whose corners are the box's, whatever its cells' shape.
DistanceGrid gridOver(const Box& box, const std::array<int, 3>& dimensions);

} // namespace evolving

#endif
