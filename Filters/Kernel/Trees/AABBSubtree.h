// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A part of an AABBTree, built alone (algorithm 4 of the thesis).
 */

#ifndef EVOLVING_AABB_SUBTREE_H
#define EVOLVING_AABB_SUBTREE_H

#include "Trees/BoxNode.h"
#include "Trees/FloatBox.h"
#include "Trees/RootFrame.h"
#include "Trees/SurfaceAreaSplit.h"
#include "Trees/TriangleGeometry.h"
#include "Types.h"

#include <cstdint>
#include <vector>

namespace evolving
{

/// A triangle and the box of its part in a node, rounded outwards, in the root's frame.
struct TriangleReference
{
  Index triangle = NoIndex;
  FloatBox box;
};
using TriangleReferences = std::vector<TriangleReference>;

FloatBox boxAround(const TriangleReferences& references);

/// What is below a node, numbered as if there were nothing else.
struct AABBSubtree
{
  std::vector<BoxNode> nodes; ///< parents before children
  std::vector<std::int8_t> levels;
  std::vector<Index> leafTriangles;
  std::vector<FloatBox> leafBoxes; ///< around the part of each leaf triangle, in the root's frame
};

/// Divides references until leaves are left. One for each thread.
class AABBSubtreeBuilder
{
public:
  /// @param epsilon by which boxes are inflated, in the root's frame
  AABBSubtreeBuilder(const std::vector<Triangle>& triangles, const RootFrame& frame, double epsilon)
    : Triangles(triangles)
    , Frame(frame)
    , Epsilon(epsilon)
  {
  }

  AABBSubtree build(TriangleReferences references, int level);

  /// Divides the references in a box at the best split; false when there are few or it does not
  /// pay.
  bool split(const TriangleReferences& references, const FloatBox& box, int level,
    TriangleReferences& left, TriangleReferences& right);
  /// The box of references, inflated, in the model's coordinates.
  Box nodeBox(const FloatBox& box) const { return this->Frame.global(this->inflated(box)); }

private:
  Index addNode(TriangleReferences& references, int level);
  /// Shrinks the halves of a reference to its triangle's parts on the two sides of a plane.
  void clip(TriangleReference& left, TriangleReference& right, int axis, float position) const;
  Box inflated(const FloatBox& box) const;
  void fillLeaf(Index node, const TriangleReferences& references);

  const std::vector<Triangle>& Triangles;
  const RootFrame& Frame;
  double Epsilon;
  std::vector<SplitInterval> Intervals;
  AABBSubtree Result;
};

} // namespace evolving

#endif
