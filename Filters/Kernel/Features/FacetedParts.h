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

/// Which folds of a part with facets are edges of these; angles in degrees.
struct FacetFolds
{
  double seen = 30.0; ///< folds by more are seen, and say whether there are facets
  /// Folds by more are edges, too: along an edge that is left out facets are rounded, and the folds
  /// around it waver.
  double faint = 5.0;
  /// But no faint edge at a smaller angle to another one: elements could not be good between them.
  double leastWedge = 36.0;
};

/**
 * Of those connected parts that have no sharp edge, takes in the edges between facets, where those
 * that are seen are long on average, each counted by its length. Elements much shorter than such an
 * edge show the fold as what it is, an edge: on it, or as a saw beside it. Of faint edges in each
 * other's way the one with the larger fold is taken in.
 * @param leastMean in the target's unit
 */
void takeFacetEdges(
  const TargetTriangles& target, SharpEdges& sharp, const FacetFolds& folds, double leastMean);

} // namespace evolving

#endif
