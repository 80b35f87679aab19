// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which points have the same coordinates. The mesh whose points are joined by it is that of
 * weldCoincidentPoints() in SurfaceMesh.h.
 */

#ifndef EVOLVING_POINT_WELDING_H
#define EVOLVING_POINT_WELDING_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * For every point of `among` the smallest number of a point of `among` with equal coordinates (0
 * and -0 are equal); NoIndex for all others.
 * @param among different numbers of points that are not NaN: those have no order
 */
std::vector<Index> firstOfEqualPoints(const std::vector<Vec3>& points, std::vector<Index> among);

/**
 * For every point the number of the vertex that has its coordinates, NoIndex where none has.
 * @param vertices all finite; of equal ones the first counts
 */
std::vector<Index> vertexOfEachPoint(
  const std::vector<Vec3>& points, const std::vector<Vec3>& vertices);

/// The vertices that faces use, in ascending order.
std::vector<Index> usedVertices(const SurfaceMesh& mesh);

/// Gives those consecutive numbers, and drops the points that no face uses.
/// @param[out] oldVertex when not null, for every new vertex its old number
void dropUnusedPoints(SurfaceMesh& mesh, std::vector<Index>* oldVertex = nullptr);

/**
 * As weldCoincidentPoints() does, for points that are to be one.
 * @param first of every vertex that a face uses, the smallest one that it is to be one with
 */
SurfaceMesh joinVertices(const SurfaceMesh& mesh, const std::vector<Index>& first,
  std::vector<Index>* oldVertex = nullptr, std::vector<Index>* oldFace = nullptr);

} // namespace evolving

#endif
