// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What a tree is to answer, by looking at every triangle.
 */

#ifndef EVOLVING_TESTING_ALL_TRIANGLES_H
#define EVOLVING_TESTING_ALL_TRIANGLES_H

#include "Trees/AABBTree.h"

#include <limits>

namespace evolving::test
{

/// Of several at the same distance the first.
inline Index closestOfAll(const AABBTree& tree, const Vec3& point)
{
  Index closest = NoIndex;
  double smallest = std::numeric_limits<double>::infinity();
  for (Index t = 0; t < tree.triangleCount(); ++t)
  {
    const double squared = MeasuredTriangle<double>(tree.triangle(t)).squaredDistance(point);
    if (squared < smallest)
    {
      smallest = squared;
      closest = t;
    }
  }
  return closest;
}

} // namespace evolving::test

#endif
