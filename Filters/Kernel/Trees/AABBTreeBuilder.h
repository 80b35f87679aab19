// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The construction of an AABBTree on several threads.
 */

#ifndef EVOLVING_AABB_TREE_BUILDER_H
#define EVOLVING_AABB_TREE_BUILDER_H

#include "Execution.h"
#include "Trees/AABBSubtree.h"
#include "Trees/AABBTree.h"
#include "Trees/FloatBox.h"
#include "Trees/RootFrame.h"
#include "Types.h"

#include <cstddef>
#include <vector>

namespace evolving
{

/// The upper levels one after the other, then what is below them side by side.
class AABBTreeBuilder
{
public:
  /// Fills the nodes of a tree that has its triangles. @throws Cancelled
  static void build(AABBTree& tree, const Execution& execution);

private:
  /// A node of the upper levels; those without halves have a subtree.
  struct UpperNode
  {
    Box box;
    int level = 0;
    std::size_t left = 0; ///< 0, the root, for none
    std::size_t right = 0;
    TriangleReferences references; ///< of the subtree
    AABBSubtree subtree;

    bool hasHalves() const { return this->left != 0; }
  };

  AABBTreeBuilder(AABBTree& tree, const Execution& execution);

  TriangleReferences allTriangles() const;
  std::size_t addUpper(TriangleReferences references, int level);
  void buildSubtrees();
  Index append(const UpperNode& upper);
  Index append(const AABBSubtree& subtree);
  /// The triangles of leaves of many, and all nodes as if those leaves were empty.
  std::vector<Index> crowdedTriangles() const;
  std::vector<BoxNode> uncrowdedNodes() const;

  AABBTree& Tree;
  const Execution& Run;
  RootFrame Frame;
  double Epsilon = 0.0; ///< in the frame
  std::vector<UpperNode> Upper;
  std::vector<FloatBox> LeafBoxes;
};

} // namespace evolving

#endif
