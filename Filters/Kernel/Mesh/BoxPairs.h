// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The pairs of boxes that overlap: the broad phase of intersection tests.
 */

#ifndef EVOLVING_BOX_PAIRS_H
#define EVOLVING_BOX_PAIRS_H

#include "Execution.h"
#include "Types.h"

#include <functional>
#include <utility>
#include <vector>

namespace evolving
{

/// Two numbers, the smaller one first.
using IndexPair = std::pair<Index, Index>;

/// Asked, on any thread, about two boxes that overlap or touch.
using PairPredicate = std::function<bool(Index, Index)>;

/**
 * The pairs of overlapping or touching boxes that the predicate wants, sorted. Empty boxes overlap
 * nothing. Takes n log n time for boxes of any mixture of sizes, plus the time of the pairs.
 * @throws Cancelled
 */
std::vector<IndexPair> overlappingPairs(
  const std::vector<Box>& boxes, const PairPredicate& isWanted, const Execution& execution = {});

/**
 * For each of a few boxes the numbers of the others that overlap or touch it, in ascending order.
 * Looks at each of the others once, whatever the number of the few.
 * @throws Cancelled
 */
std::vector<std::vector<Index>> boxesOverlapping(
  const std::vector<Box>& few, const std::vector<Box>& others, const Execution& execution = {});

} // namespace evolving

#endif
