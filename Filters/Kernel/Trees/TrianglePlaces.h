// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Where on a mesh of triangles the points closest to given ones lie.
 */

#ifndef EVOLVING_TRIANGLE_PLACES_H
#define EVOLVING_TRIANGLE_PLACES_H

#include "Execution.h"
#include "Trees/AABBTree.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// A point of a triangle.
struct TrianglePlace
{
  Index triangle = NoIndex;
  Vec3 weights = Vec3::UnitX(); ///< of its corners: barycentric, none negative, their sum 1
};

/// The place closest to a point. @param tree not empty
TrianglePlace closestPlace(const AABBTree& tree, const Vec3& point);

/// The places closest to points, in parallel. @param tree not empty. @throws Cancelled
std::vector<TrianglePlace> closestPlaces(
  const AABBTree& tree, const std::vector<Vec3>& points, const Execution& execution = {});

} // namespace evolving

#endif
