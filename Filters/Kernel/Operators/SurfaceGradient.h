// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The gradient of a function on a surface.
 */

#ifndef EVOLVING_SURFACE_GRADIENT_H
#define EVOLVING_SURFACE_GRADIENT_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Operators/FiniteVolumes.h"

#include <vector>

namespace evolving
{

/**
 * The gradient of a function given at the vertices: at every vertex the mean of the gradients in
 * the incident triangles weighted by their areas, sum_T (A_T / 3) grad f_T / mu_i. Polygons
 * contribute through the fan around their virtual vertex. On a curved surface the result has a
 * small part along the normal.
 * @param volumes of this mesh
 * @param values one per vertex
 */
std::vector<Vec3> surfaceGradient(const SurfaceMesh& mesh, const FiniteVolumes& volumes,
  const std::vector<double>& values, const Execution& execution);

} // namespace evolving

#endif
