// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Fewer charts, where more are not needed.
 */

#ifndef EVOLVING_CHART_MERGING_H
#define EVOLVING_CHART_MERGING_H

#include "Features/SeparatedSets.h"
#include "Features/SharpEdges.h"
#include "Features/TargetTriangles.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * Merges charts that share a border which is not sharp, the pair with the longest one first.
 * @param[in,out] charts which of them must stay apart
 * @param[in,out] names the chart of every triangle, by a triangle of it
 */
void mergeCharts(const TargetTriangles& target, const SharpEdges& sharp, SeparatedSets& charts,
  std::vector<Index>& names);

} // namespace evolving

#endif
