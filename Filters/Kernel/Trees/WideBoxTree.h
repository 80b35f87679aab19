// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A tree of boxes for the question "which is closest", laid out for SIMD registers.
 */

#ifndef EVOLVING_WIDE_BOX_TREE_H
#define EVOLVING_WIDE_BOX_TREE_H

#include "Trees/BoxNode.h"
#include "Trees/FloatBox.h"
#include "Trees/NearestFirst.h"
#include "Trees/RootFrame.h"
#include "Types.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace evolving
{

/// Some boxes side by side. Where there is none, its place is infinitely far from everything.
class BoxRow
{
public:
  static constexpr int Length = 8;
  using Lanes = Eigen::Array<float, Length, 1>;

  BoxRow();
  void set(int place, const FloatBox& box);

  /// The squared distances from a point to the boxes, each grown by a margin; 0 inside.
  Lanes squaredGaps(const Eigen::Vector3f& point, float margin) const
  {
    Lanes sum = Lanes::Zero();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const float p = point[static_cast<Eigen::Index>(axis)];
      const Lanes gap = (this->Minimum[axis] - p).max(p - this->Maximum[axis]) - margin;
      sum += gap.max(0.0F).square();
    }
    return sum;
  }

private:
  std::array<Lanes, 3> Minimum;
  std::array<Lanes, 3> Maximum;
};

/**
 * A binary tree of boxes over triangles with three of its levels in one, and the boxes of a
 * leaf's triangles in place of the leaf's. Its floats count in the root's frame; their rounding may
 * let a triangle pass in vain, but never hides one.
 */
class WideBoxTree
{
public:
  WideBoxTree() = default;
  /**
   * @param nodes of the binary tree, the root first
   * @param leafTriangles of all leaves one after the other
   * @param leafBoxes around the part of each in its leaf, in the root's frame
   */
  WideBoxTree(const std::vector<BoxNode>& nodes, const std::vector<Index>& leafTriangles,
    const std::vector<FloatBox>& leafBoxes, const RootFrame& frame);

  /**
   * Calls squaredBound = visit(triangle) for those whose boxes come at least as near to a point
   * as the bound says then; near ones first, some more than once.
   */
  template <typename Visit>
  void visitNear(const Vec3& point, double squaredBound, const Visit& visit) const;

private:
  friend class WideBoxTreeBuilder;

  struct Node
  {
    BoxRow boxes;
    std::array<Index, BoxRow::Length> children{}; ///< as visitNearestFirst() has them
    int childCount = 0;
  };
  /// On each level all but one wait: those of the binary tree, and of leaves with many triangles.
  static constexpr std::size_t MostPending = (BoxRow::Length - 1) * (BoxNode::MostLevels + 11) + 1;

  /// To where the floats count from; never farther away than the point.
  Eigen::Vector3f local(const Vec3& point) const
  {
    constexpr double Farthest = 1e6;
    return this->Frame.local(point).cwiseMax(-Farthest).cwiseMin(Farthest).cast<float>();
  }
  float localSquare(double square) const
  {
    constexpr double RoundedUp = 1.0 + 1e-6;
    return static_cast<float>(RoundedUp * this->Frame.localSquare(square));
  }

  std::vector<Node> Nodes;
  RootFrame Frame;
};

template <typename Visit>
void WideBoxTree::visitNear(const Vec3& point, double squaredBound, const Visit& visit) const
{
  constexpr float Rounding = 2.5e-7F; // of the point, and of its differences from the boxes
  const Eigen::Vector3f p = this->local(point);
  const float margin = Rounding * (1.0F + p.cwiseAbs().maxCoeff());
  visitNearestFirst<MostPending>(
    this->Nodes, this->localSquare(squaredBound),
    [&](const Node& node) { return node.boxes.squaredGaps(p, margin); },
    [&](Index triangle) { return this->localSquare(visit(triangle)); });
}

} // namespace evolving

#endif
