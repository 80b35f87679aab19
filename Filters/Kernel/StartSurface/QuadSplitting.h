// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * From quads to triangles.
 */

#ifndef EVOLVING_QUAD_SPLITTING_H
#define EVOLVING_QUAD_SPLITTING_H

#include "Mesh/SurfaceMesh.h"

namespace evolving
{

/**
 * Splits every quad along the diagonal whose two triangles have the larger smallest angle; where
 * both diagonals are equally good, along the one with the flatter edge; where those are equal
 * too, from the quad's first corner. Other faces are kept; points are too.
 */
SurfaceMesh splitQuads(const SurfaceMesh& mesh);

} // namespace evolving

#endif
