// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The icosphere start: a sphere of triangles that encloses the target.
 */

#ifndef EVOLVING_BOUNDING_ICOSPHERE_H
#define EVOLVING_BOUNDING_ICOSPHERE_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

namespace evolving
{

/// The radius of the largest sphere inside icosphere(level) of radius 1.
double icosphereInradius(int level);

/**
 * An icosphere about a box's centre whose triangles, not only its vertices, stay outside the
 * sphere of radius (1 + margin) * half the box's diagonal.
 * @param margin fraction of half the diagonal, not negative
 * @throws InputError for an empty or infinite box, a box that is a point, a negative margin or a
 * level out of range
 */
SurfaceMesh boundingIcosphere(const Box& box, int level, double margin);

} // namespace evolving

#endif
