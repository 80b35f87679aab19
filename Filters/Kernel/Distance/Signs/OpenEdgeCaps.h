// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Caps over the holes of a surface.
 */

#ifndef EVOLVING_OPEN_EDGE_CAPS_H
#define EVOLVING_OPEN_EDGE_CAPS_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/**
 * Triangles between the points of the open edges that close a surface: along every edge, the
 * directed faces of the surface and its caps together cancel. Their winding number is a whole
 * number, and that of the surface is this one less that of the caps. They need not be good caps:
 * they may cut the surface and each other.
 *
 * Each loop of edges is halved again and again, with a triangle over each half and the points at
 * which it is halved: few are large, and those at the edges are short.
 * @param openEdges as OrientationSummary has them
 */
std::vector<std::array<Index, 3>> capsOver(
  const std::vector<std::array<Index, 2>>& openEdges, Index pointCount);

} // namespace evolving

#endif
