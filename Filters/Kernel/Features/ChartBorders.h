// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Where the artificial borders between charts run best.
 */

#ifndef EVOLVING_CHART_BORDERS_H
#define EVOLVING_CHART_BORDERS_H

#include "Features/SharpEdges.h"
#include "Features/TargetTriangles.h"
#include "Types.h"

#include <map>
#include <utility>
#include <vector>

namespace evolving
{

/// The lengths of borders that are not sharp, by the names on both sides, the smaller first.
using BorderLengths = std::map<std::pair<Index, Index>, double>;

BorderLengths artificialBorders(
  const TargetTriangles& target, const SharpEdges& sharp, const std::vector<Index>& names);

/**
 * Moves the borders between charts to where they are short and the surface folds most: an edge
 * costs its length, less up to nine tenths of it the closer its fold comes to that of a crease.
 * For one pair of neighbours after the other that is the minimum cut between the fixed triangles
 * of each (the swap moves of Boykov, Veksler and Zabih 2001), until no border gets cheaper.
 * @param isFixed triangles that keep their names; at least those beside darts
 */
void improveBorders(const TargetTriangles& target, const SharpEdges& sharp,
  const std::vector<char>& isFixed, std::vector<Index>& names);

} // namespace evolving

#endif
