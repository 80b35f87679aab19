// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Normals of triangles that can be compared across edges, slivers included.
 */

#ifndef EVOLVING_FACE_NORMALS_H
#define EVOLVING_FACE_NORMALS_H

#include "Features/TargetTriangles.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * The unit normal of every triangle, on the side from which its corners run counter-clockwise.
 * The plane of a triangle lower than 1e-6 of the surface's diagonal is rounding error where
 * points were stored as floats; such a sliver takes the normal from beyond its longest edge, so
 * that a crease through it runs along its two short ones. Zero when no neighbour has a normal.
 */
std::vector<Vec3> faceNormals(const TargetTriangles& target);

/**
 * The angle between the normals of the faces of two corners along the same edge, in degrees, as
 * if both faces were turned to the same side; 0 when one has no normal.
 */
double foldAngle(
  const TargetTriangles& target, const std::vector<Vec3>& normals, Index cornerA, Index cornerB);

} // namespace evolving

#endif
