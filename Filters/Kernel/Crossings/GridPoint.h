// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Points of a triangle on a grid of integers.
 */

#ifndef EVOLVING_GRID_POINT_H
#define EVOLVING_GRID_POINT_H

#include <cstdint>

namespace evolving
{

/// Barycentric coordinates of a triangle's second and third corner, in 2^30ths: which side of a
/// line a point is on is then exact, and points on a side of the triangle lie on it exactly.
struct GridPoint
{
  static constexpr std::int64_t Unit = std::int64_t(1) << 30;

  std::int64_t x = 0;
  std::int64_t y = 0;
};

/// 1 where a, b, c run counter-clockwise, -1 where clockwise, 0 on a line.
inline int gridOrientation(const GridPoint& a, const GridPoint& b, const GridPoint& c)
{
  const std::int64_t area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return static_cast<int>(area > 0) - static_cast<int>(area < 0);
}

/// Is the angle at a between b and c acute?
inline bool isAhead(const GridPoint& a, const GridPoint& b, const GridPoint& c)
{
  return (b.x - a.x) * (c.x - a.x) + (b.y - a.y) * (c.y - a.y) > 0;
}

} // namespace evolving

#endif
