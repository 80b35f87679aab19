// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Parts that share points or edges, taken apart.
 */

#ifndef EVOLVING_SEPARATE_SOLIDS_H
#define EVOLVING_SEPARATE_SOLIDS_H

#include "Mesh/SurfaceMesh.h"

namespace evolving
{

/**
 * The same triangles, in the same order, with points of their own for what only meets in a point,
 * and for solids that meet in an edge: where as many faces run along it one way as the other, each
 * goes on in the face that bounds the same solid, as the faces are turned. Edges of any other
 * number of faces stay.
 * @param surface triangles, welded
 */
SurfaceMesh separateSolids(const SurfaceMesh& surface);

} // namespace evolving

#endif
