// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which edges of a surface make its curves: those of the boundary, and sharp ones.
 */

#ifndef EVOLVING_CURVE_EDGES_H
#define EVOLVING_CURVE_EDGES_H

#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving
{

/**
 * For every vertex the other ends of its curve edges: of the boundary, and of edges whose faces'
 * normals differ by more than creaseAngle (degrees) where enough of them are connected, or they
 * are connected to the boundary. Enough is 12, the edges of a cube, or a quarter of all edges of a
 * coarse mesh; a few are no crease but the rough places and thin triangles of scans, where normals
 * of neighbouring faces differ, too.
 */
std::vector<std::vector<Index>> curveNeighbours(
  const SurfaceMesh& mesh, const MeshTopology& topology, double creaseAngle);

} // namespace evolving

#endif
