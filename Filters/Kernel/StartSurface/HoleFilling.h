// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Caps of triangles for the holes of a mesh.
 */

#ifndef EVOLVING_HOLE_FILLING_H
#define EVOLVING_HOLE_FILLING_H

#include "Execution.h"
#include "Mesh/BoundaryLoops.h"
#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving
{

/**
 * The mesh with a cap on each loop, oriented as most of the faces at it. Points, and faces with
 * their numbers, stay; the caps' triangles follow.
 *
 * Loops of up to 300 vertices get a cap of least area (LeastAreaCap.h) that shares no inner edge
 * with the mesh; where there is none they stay open. Where the cap crosses itself or the mesh, it
 * is chosen again without the edges of the triangles that do, up to four times; the choice with the
 * fewest such triangles stands. Longer loops are cut into triangles ear by ear, which is right
 * where they are nearly planar.
 * @param mesh of triangles
 * @param holes of boundaryLoops(mesh)
 * @throws InputError when a face is not a triangle or the mesh does not pass validate()
 * @throws Cancelled
 */
SurfaceMesh fillHoles(
  const SurfaceMesh& mesh, const std::vector<BoundaryLoop>& holes, const Execution& execution = {});

} // namespace evolving

#endif
