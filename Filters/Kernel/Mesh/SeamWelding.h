// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Seams of a surface whose sides differ by rounding.
 */

#ifndef EVOLVING_SEAM_WELDING_H
#define EVOLVING_SEAM_WELDING_H

#include "Mesh/SurfaceMesh.h"

namespace evolving
{

/**
 * Joins points of open edges that are no farther apart than a tolerance, in chains too: the last
 * column of a surface of revolution misses the first by rounding. Each takes the place of the
 * smallest number. The ends of an edge are not joined: a needle is no seam.
 * @param mesh triangles, welded
 * @param tolerance a length; 0 changes nothing
 */
SurfaceMesh weldSeams(const SurfaceMesh& mesh, double tolerance);

/// What writing coordinates as floats does to them at most, but no length that is of any size.
double roundingOf(const SurfaceMesh& mesh);

} // namespace evolving

#endif
