// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The edges of parts that are made of large facets, as figures of few triangles are.
 */

#ifndef EVOLVING_FACETED_PARTS_H
#define EVOLVING_FACETED_PARTS_H

#include "Features/SharpEdges.h"
#include "Features/TargetTriangles.h"

namespace evolving
{

/**
 * Of those connected parts that have no sharp edge, takes in the edges that fold by more than an
 * angle, where these are long on average, each counted by its length. Elements much shorter than
 * such an edge show the fold as what it is, an edge: on it, or as a saw beside it.
 * @param angle in degrees
 * @param leastMean in the target's unit
 */
void takeFacetEdges(
  const TargetTriangles& target, SharpEdges& sharp, double angle, double leastMean);

} // namespace evolving

#endif
