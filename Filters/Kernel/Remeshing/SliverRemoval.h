// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What a contour filter hands over, without the slivers.
 */

#ifndef EVOLVING_SLIVER_REMOVAL_H
#define EVOLVING_SLIVER_REMOVAL_H

#include "Mesh/SurfaceMesh.h"

#include <optional>

namespace evolving
{

/**
 * Takes the slivers out of a surface. Where a contour passes close to a sample, marching cubes puts
 * points almost on top of each other: triangles become needles, as short as rounding, or caps. Here
 * the short edges of such triangles collapse and the long ones flip, which changes nothing farther
 * away than a few edges.
 *
 * - Only where the surface, and its boundary, moves by no more than a fiftieth of the edges around:
 *   thin plates, creases, corners and the short edges around a neck are no slivers and stay.
 * - A surface without slivers, and the elements of any size of a graded one, stay as they are.
 *
 * @param surface an oriented manifold of triangles, closed or with boundary
 * @return nothing when nothing had to be, or could be, changed
 * @throws InputError as EditableSurface
 */
std::optional<SurfaceMesh> withoutSlivers(const SurfaceMesh& surface);

} // namespace evolving

#endif
