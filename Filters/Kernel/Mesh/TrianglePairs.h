// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Whether two triangles of a mesh intersect where they should not. Exact.
 */

#ifndef EVOLVING_TRIANGLE_PAIRS_H
#define EVOLVING_TRIANGLE_PAIRS_H

#include "Mesh/TriangleView.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// Whether the corners do not lie on one line.
bool hasArea(const std::vector<Vec3>& points, const TriangleVertices& triangle);

/**
 * Whether two triangles with area have a point in common that is in none of their shared vertices
 * and edges. Triangles are closed: touching counts. Vertices are shared when their numbers are
 * equal; equal points with different numbers touch.
 *
 * Three shared vertices: always. Two: when one triangle is folded flat onto the other. One: when
 * the edge opposite to it, of either triangle, meets the other triangle. None: when an edge of
 * either triangle meets the other.
 */
bool intersectBeyondShared(
  const std::vector<Vec3>& points, TriangleVertices first, TriangleVertices second);

} // namespace evolving

#endif
