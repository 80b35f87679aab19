// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which parts of a target have an inside of their own.
 */

#ifndef EVOLVING_CLOSED_PARTS_H
#define EVOLVING_CLOSED_PARTS_H

#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving
{

/**
 * Does a face belong to a part that is a closed manifold, and no thin plate? Parts are connected by
 * edges. Faces that use a point twice have no say: where two corners were welded the part is closed
 * without them.
 * @param surface triangles, welded
 * @param thickness parts whose mean thickness, twice their volume over their area, is not larger
 *   are as sheets
 * @return a flag per face
 */
std::vector<char> facesOfClosedParts(const SurfaceMesh& surface, double thickness);

} // namespace evolving

#endif
