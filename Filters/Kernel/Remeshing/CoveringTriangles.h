// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Of equilateral triangles that cover an area: their edge length, and how many vertices they have.
 */

#ifndef EVOLVING_COVERING_TRIANGLES_H
#define EVOLVING_COVERING_TRIANGLES_H

#include <cmath>

namespace evolving
{

/// sqrt(2 A / (N sqrt(3))): each vertex has two triangles.
inline double coveringEdgeLength(double area, double vertexCount)
{
  return std::sqrt(2.0 * area / (vertexCount * std::sqrt(3.0)));
}

/// The other way round.
inline double coveringVertexCount(double area, double edgeLength)
{
  return 2.0 * area / (std::sqrt(3.0) * edgeLength * edgeLength);
}

} // namespace evolving

#endif
