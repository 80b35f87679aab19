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
 * the angles of faces along it: those do not count, unless the boundary is free. New elements know
 * nothing of sharp edges and would make saws of them, so that a surface with some gets time: the
 * flow rounds them off within a few steps, where its elements are small.
 * @param edgeLength of new elements; sharp edges between larger ones stay whatever the flow does
 */
bool hasDegenerateElements(const SurfaceMesh& surface, BoundaryMode mode, double edgeLength);

/// Has it less than a quarter of the vertices that it should have? Then it cannot show what it is
/// to become. An icosphere of level 3, the usual start, has just as many.
bool isCoarse(const SurfaceMesh& surface, double wantedVertices);

/// How many vertices a surface shall have on its way: as many as it has, but enough to look smooth.
double wantedVertices(const SurfaceMesh& start);

} // namespace evolving

#endif
