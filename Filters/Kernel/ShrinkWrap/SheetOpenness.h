// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * From how many sides a target can be reached.
 */

#ifndef EVOLVING_SHEET_OPENNESS_H
#define EVOLVING_SHEET_OPENNESS_H

#include "ShrinkWrap/OuterRegion.h"
#include "Trees/AABBTree.h"
#include "Types.h"

namespace evolving
{

enum class SidesOpen : char
{
  One,
  Varying, ///< from one here and from both there
  Both,
};

class SheetOpenness
{
public:
  /// @param tree of the target; both are kept
  SheetOpenness(const AABBTree& tree, const OuterRegion& region)
    : Tree(tree)
    , Region(region)
  {
  }

  /// Can both sides of the target be reached at a point of a triangle? 0 to 1.
  double at(Index triangle, const Vec3& point) const;
  /// Of a triangle, by some of its points.
  SidesOpen sidesOf(Index triangle) const;

private:
  /// The same, and 0 for what is not above a value.
  double above(double least, Index triangle, const Vec3& point) const;
  double reachableFrom(Index triangle, const Vec3& point, const Vec3& side) const;

  const AABBTree& Tree;
  const OuterRegion& Region;
};

} // namespace evolving

#endif
