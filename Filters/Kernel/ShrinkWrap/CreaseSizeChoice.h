// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How small elements may be beside the creases of a target, for a number of points.
 */

#ifndef EVOLVING_CREASE_SIZE_CHOICE_H
#define EVOLVING_CREASE_SIZE_CHOICE_H

#include "Execution.h"
#include "Features/CreaseSizes.h"
#include "ShrinkWrap/OuterRegion.h"
#include "ShrinkWrap/ShrinkWrapOptions.h"
#include "ShrinkWrap/WrapReference.h"

#include <memory>

namespace evolving
{

struct PointBudget
{
  double points = 0.0;
  double edgeLength = 0.0;  ///< of edges away from creases
  double longestEdge = 0.0; ///< as long as those may become to save points; not below edgeLength
  double across = 0.0;      ///< so many edges between two creases
  /// Must points not be exceeded? Then they are counted on the target, where sizes are smallest.
  /// A number to come near to is counted on the start surface, a little way off.
  bool isLimit = false;
};

/**
 * The sizes with the shortest edges, down to an eighth of the others, that a budget allows beside
 * the creases to preserve.
 * @param region of the same view; its boundary is about as large as the result
 * @return null where there are no such creases, they ask for no shorter edges, or no budget does
 * @throws Cancelled
 */
std::shared_ptr<const CreaseSizes> chooseCreaseSizes(const ShrinkWrapOptions& options,
  const WrapReference& reference, const OuterRegion& region, const PointBudget& budget,
  const Execution& execution = {});

} // namespace evolving

#endif
