// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How many vertices remeshing may be asked for.
 */

#ifndef EVOLVING_VERTEX_BUDGET_H
#define EVOLVING_VERTEX_BUDGET_H

#include "Remeshing/EditableSurface.h"

namespace evolving
{

/// More take an hour: 9000 vertices of a wrap take one to two seconds, and those far from the
/// target ten times as long.
constexpr double MostVertices = 2e6;

/**
 * How many vertices remeshing makes: those that the area needs, and of needles, however little area
 * they have, those that come where their long sides are split.
 */
double verticesToMake(const EditableSurface& surface);

/**
 * Refuses a surface whose sizes ask for too many vertices, before any is made.
 * @param edgeLength of which the sizes are made, to be named
 * @throws InputError
 */
void requireFewVertices(
  const EditableSurface& surface, double edgeLength, double most = MostVertices);

} // namespace evolving

#endif
