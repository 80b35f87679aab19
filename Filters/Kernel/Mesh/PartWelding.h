// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which points are one, of surfaces that are closed already and of others.
 */

#ifndef EVOLVING_PART_WELDING_H
#define EVOLVING_PART_WELDING_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * For every vertex that a face uses, the smallest vertex that it is one with; NoIndex for others.
 * Points with equal coordinates are one, as in weldCoincidentPoints(), but for those of a part that
 * is closed as it is: its vertices are who they are, wherever they lie. So the surface of a label
 * that touches itself, or another one, stays the manifold that it is, while soups are put together
 * and seams closed.
 *
 * A part is what hangs together by common vertices. It is closed when every edge has two faces that
 * run along it in opposite directions, and no face has two corners at one place.
 */
std::vector<Index> verticesToJoin(const SurfaceMesh& mesh);

/// As weldCoincidentPoints(), but for parts that are closed as they are.
SurfaceMesh weldOpenParts(const SurfaceMesh& mesh, std::vector<Index>* oldVertex = nullptr,
  std::vector<Index>* oldFace = nullptr);

} // namespace evolving

#endif
