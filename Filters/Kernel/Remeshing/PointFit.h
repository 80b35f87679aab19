// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A surface moves along its normals to lie amidst points.
 */

#ifndef EVOLVING_POINT_FIT_H
#define EVOLVING_POINT_FIT_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Remeshing/EditableSurface.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * Moves vertices along their normals so that the squared distances of the points from the surface
 * become small, and the moves of neighbours alike: linear least squares, every point being measured
 * along the normal of its closest face (Gauss-Newton).
 * @param stiffness of the moves, relative to one point at a vertex: where there is no point, it
 * alone decides
 */
void fitToPoints(EditableSurface& surface, const std::vector<Vec3>& points, double stiffness,
  int iterations, const Execution& execution = {});

} // namespace evolving

#endif
