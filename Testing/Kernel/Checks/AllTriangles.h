// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What a tree or a grid of distances is to answer, by looking at every triangle.
 */

#ifndef EVOLVING_TESTING_ALL_TRIANGLES_H
#define EVOLVING_TESTING_ALL_TRIANGLES_H

#include "Mesh/SurfaceMesh.h"
#include "Trees/AABBTree.h"
#include "Trees/TriangleGeometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evolving::checks
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

/// The distance by the definition: segments and points are as good as other triangles.
inline double distanceToAll(const SurfaceMesh& mesh, const Vec3& point)
{
  double squared = std::numeric_limits<double>::infinity();
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    squared =
      std::min(squared, closestPointOnTriangle(point, triangleOf(mesh, face)).squaredDistance);
  }
  return std::sqrt(squared);
}

} // namespace evolving::checks

#endif
