// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Does a surface need new elements?
 */

#ifndef EVOLVING_DEGENERATE_ELEMENTS_H
#define EVOLVING_DEGENERATE_ELEMENTS_H

#include "Mesh/SurfaceMesh.h"
#include "Redistribution/RedistributionOptions.h"

namespace evolving
{

/**
 * Has it a face with an angle too small to go on with? A boundary that keeps its shape decides on
 * the angles of faces along it: those do not count, unless the boundary is free.
 */
bool hasDegenerateElements(const SurfaceMesh& surface, BoundaryMode mode);

/**
 * The edge length with which as many equilateral triangles cover a surface as it has vertices, but
 * no fewer than show a smooth shape. Needles, as CAD programs make them, have a much larger mean.
 */
double coveringEdgeLength(const SurfaceMesh& surface);

} // namespace evolving

#endif
