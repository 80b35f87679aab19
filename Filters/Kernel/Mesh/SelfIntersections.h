// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Where a triangle mesh runs through itself.
 */

#ifndef EVOLVING_SELF_INTERSECTIONS_H
#define EVOLVING_SELF_INTERSECTIONS_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Mesh/TriangleView.h"
#include "Types.h"

#include <utility>
#include <vector>

namespace evolving
{

/**
 * The pairs of triangles that have more in common than the vertices and edges they share by
 * number: crossing, touching, lying on each other or folded flat onto each other. Exact for the
 * coordinates as they are. Triangles without area are left out: they bound nothing. Weld a mesh
 * first, or all its neighbours touch.
 * @return each pair with the smaller number first, sorted
 * @throws InputError when a face is not a triangle or the mesh does not pass validate()
 * @throws Cancelled
 */
std::vector<std::pair<Index, Index>> selfIntersections(
  const SurfaceMesh& triangles, const Execution& execution = {});

/**
 * The same of a surface that is known to be of triangles.
 * @throws InputError when a coordinate is not finite. @throws Cancelled
 */
std::vector<std::pair<Index, Index>> selfIntersections(
  const TriangleView& triangles, const Execution& execution = {});

} // namespace evolving

#endif
