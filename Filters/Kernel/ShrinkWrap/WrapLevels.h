// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How far from each point of a target the result of shrink-wrapping is to lie.
 */

#ifndef EVOLVING_WRAP_LEVELS_H
#define EVOLVING_WRAP_LEVELS_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "ShrinkWrap/OuterRegion.h"
#include "Trees/AABBTree.h"
#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/// The target in triangles so small that the level is linear in each.
struct WrapLevels
{
  SurfaceMesh triangles;
  std::vector<std::array<double, 3>> atCorners; ///< of each triangle

  double maximum(Index triangle) const;
};

/**
 * The offset, but at sheets that can be reached from both sides at least half a wall. Triangles of
 * which only a part is such a sheet are cut until they are no larger than the region's ball, which
 * cannot tell smaller places apart.
 * @param tree of the target
 * @param hasInside of each triangle: is it on a closed part, and so no sheet?
 * @throws Cancelled
 */
WrapLevels wrapLevels(const SurfaceMesh& target, const AABBTree& tree,
  const std::vector<char>& hasInside, const OuterRegion& region, double offset, double wall,
  const Execution& execution = {});

} // namespace evolving

#endif
