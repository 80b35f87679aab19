// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The vertices of a surface around some faces.
 */

#ifndef EVOLVING_VERTICES_NEAR_H
#define EVOLVING_VERTICES_NEAR_H

#include "Mesh/SurfaceMesh.h"
#include "Remeshing/EditableSurface.h"

#include <vector>

namespace evolving
{

/**
 * @param faces triangles anywhere
 * @param sizes how far, in sizes of each vertex
 * @return not 0 for the vertex slots with a vertex within that distance of the faces
 */
std::vector<char> verticesNear(
  const EditableSurface& surface, const SurfaceMesh& faces, double sizes);

} // namespace evolving

#endif
