// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which boundary loops are holes to be filled, and which belong to the shape.
 */

#ifndef EVOLVING_HOLE_CHOICE_H
#define EVOLVING_HOLE_CHOICE_H

#include "Mesh/BoundaryLoops.h"
#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving
{

/**
 * The loops to fill before a surface is started around the mesh.
 *
 * With a gap size, those of a smaller diameter, but no outline of a flat sheet, whose cap would
 * lie on the sheet.
 *
 * With gap size 0, the holes that a scanner left, and no opening that is part of the shape:
 *  - No loop of the component spans more than 2 % of its area, and all of them together no more
 *    than 7 %. For where a larger opening stays, what surrounds it gets behind the surface anyway,
 *    and small holes are no reason to take the sheet for a solid.
 *  - The surface goes on across the loop (BoundaryLoop::continuation at least 0.4, a turn of 66
 *    degrees). A cap on the end of a pipe, however thin, would stand across its wall.
 * Measured: the holes of the bunny's scan span up to 0.5 % each and 1.8 % together and have
 * continuations from 0.71 on, an eye of suzanne 0.7 % and 0.75. The holes of a cube that is to
 * keep them span 7.9 % each and 32 % together; the openings of a teapot's parts 0.2 to 79 %,
 * with continuations up to 0.09.
 * Also with gap size 0, openings too narrow for elements to enter, as the mouth of a thin pipe.
 * @param loops boundaryLoops(mesh)
 * @param gapSize not negative
 * @param narrow with gap size 0, loops of a smaller diameter are filled in any case, but no
 * outlines
 */
std::vector<BoundaryLoop> holesToFill(const SurfaceMesh& mesh,
  const std::vector<BoundaryLoop>& loops, double gapSize, double narrow = 0.0);

} // namespace evolving

#endif
