// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Polygons cut into triangles.
 */

#ifndef EVOLVING_POLYGON_TRIANGULATION_H
#define EVOLVING_POLYGON_TRIANGULATION_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/**
 * Cuts a polygon into corners.size() - 2 triangles by clipping ears, the ear with the shortest
 * cut first: right for every simple planar polygon, convex or not, also with holes to which slits
 * lead, and a reasonable surface for one that is not planar. Thousands of corners take milliseconds
 * (n log n steps, more where long ears hold many corners).
 * @return numbers of the polygon's corners, three per triangle, in the polygon's orientation;
 * none for fewer than three
 * @throws Cancelled
 */
std::vector<std::array<Index, 3>> triangulatePolygon(
  const std::vector<Vec3>& corners, const Execution& execution = {});

/**
 * The mesh with every face cut into triangles.
 * @param[out] oldFace for every triangle the face it comes from
 * @throws Cancelled
 */
SurfaceMesh triangulate(
  const SurfaceMesh& mesh, std::vector<Index>& oldFace, const Execution& execution = {});

} // namespace evolving

#endif
