// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Creases that fade, followed to where they meet others.
 */

#ifndef EVOLVING_LOOSE_ENDS_H
#define EVOLVING_LOOSE_ENDS_H

#include "Features/SharpEdges.h"
#include "Features/TargetTriangles.h"

namespace evolving
{

/**
 * Where only one sharp edge ends at a vertex, takes in a path of weaker ones that goes on from it,
 * always by the strongest fold, if it comes to another sharp edge: a crease whose fold wavers about
 * what is enough for one is whole then. (The idea of two thresholds is that of J. Canny, A
 * computational approach to edge detection, 1986.)
 * @param weakest fold of edges to follow, in degrees
 */
void followLooseEnds(const TargetTriangles& target, SharpEdges& sharp, double weakest);

} // namespace evolving

#endif
