// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Where the edges of an object appear in an image that is not sharp.
 */

#ifndef EVOLVING_BLURRED_EDGES_H
#define EVOLVING_BLURRED_EDGES_H

#include "Mesh/SurfaceMesh.h"
#include "Operators/SurfaceGeometry.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * The places at which a surface is to meet the largest slopes of an image so that it lies on the
 * object's border. Blur of the variance s^2 draws these inwards by s^2 H / 2 where the border has
 * the mean curvature H = k1 + k2: a ball's by s^2 / r (the slope along a radius of a blurred ball
 * is a Gaussian about that place, to first order in s / r). The H of a component's mean is taken,
 * as that of a vertex is noise, which this would enlarge; and at most s, as for balls no larger
 * than the blur this says nothing.
 * @param geometry of the mesh
 * @param blur s^2, an area; 0 = sharp: the points themselves
 */
std::vector<Vec3> onBlurredEdges(
  const SurfaceMesh& mesh, const SurfaceGeometry& geometry, double blur);

} // namespace evolving

#endif
