// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The construction of an AABBTree (algorithm 4 of the thesis).
 */

#ifndef EVOLVING_AABB_TREE_BUILDER_H
#define EVOLVING_AABB_TREE_BUILDER_H

#include "Distance/AABBTree.h"
#include "Distance/FloatBox.h"
#include "Distance/SurfaceAreaSplit.h"
#include "Execution.h"

#include <vector>

namespace evolving
{

class AABBTreeBuilder
{
public:
  /// Fills the nodes of a tree that has its triangles. @throws Cancelled
  static void build(AABBTree& tree, const Execution& execution);

private:
  /// A triangle and the box of its part in a node, rounded outwards.
  struct Reference
  {
    Index triangle = NoIndex;
    FloatBox box;
  };
  using References = std::vector<Reference>;

  AABBTreeBuilder(AABBTree& tree, const Execution& execution);

  References allTriangles() const;
  Index addNode(References& references, int level);
  /// Divides the references at the best split; false when that does not pay.
  bool split(
    const References& references, const FloatBox& box, References& left, References& right);
  /// Shrinks the halves of a reference to its triangle's parts on the two sides of a plane.
  void clip(Reference& left, Reference& right, int axis, float position) const;
  void fillLeaf(Index node, const References& references);
  Box inflated(const FloatBox& box) const;
  void reportProgress(std::size_t finishedReferences);

  AABBTree& Tree;
  const Execution& Host;
  double Epsilon = 0.0; ///< by which boxes are inflated
  std::vector<SplitInterval> Intervals;
  std::vector<FloatBox> LeafBoxes; ///< around the part of each of the tree's leaf triangles
  std::size_t Finished = 0;
  std::size_t SinceReport = 0;
};

} // namespace evolving

#endif
