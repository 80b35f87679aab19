// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which of many points in a plane lie in a triangle?
 */

#ifndef EVOLVING_PLANE_POINT_TREE_H
#define EVOLVING_PLANE_POINT_TREE_H

#include "Types.h"

#include <array>
#include <cstddef>
#include <vector>

namespace evolving
{

using Vec2 = Eigen::Vector2d;

/**
 * Points in halves of halves along the longer side of their box (a k-d tree), of which one after
 * the other is taken out.
 */
class PlanePointTree
{
public:
  explicit PlanePointTree(std::vector<Vec2> points);

  void remove(Index point);

  /**
   * Calls visit(point) for the points left that lie in a triangle, and for some beside it, until
   * it returns true. Points in the triangle but for rounding are among them.
   * @param corners counter-clockwise
   * @return whether it did
   */
  template <typename Visit>
  bool visitTriangle(const std::array<Vec2, 3>& corners, const Visit& visit) const;

private:
  using Box2 = Eigen::AlignedBox2d;

  struct Node
  {
    Box2 box;
    Index begin = 0; ///< in Order
    Index end = 0;
    Index right = NoIndex; ///< NoIndex for leaves; the left child follows its parent
    Index left = 0;        ///< points that were not taken out
  };

  /// What lies to the left of all three edges, or nearly.
  class Wedge
  {
  public:
    Wedge(const std::array<Vec2, 3>& corners, double size);
    bool meets(const Box2& box) const;

  private:
    Box2 Bounds;
    std::array<Vec2, 3> Inwards; ///< of each edge
    std::array<double, 3> Least; ///< along it
  };

  Index addNode(Index begin, Index end);

  std::vector<Vec2> Points;
  std::vector<Index> Order; ///< of the leaves
  std::vector<Index> Place; ///< of each point in Order
  std::vector<char> IsOut;
  std::vector<Node> Nodes;
};

template <typename Visit>
bool PlanePointTree::visitTriangle(const std::array<Vec2, 3>& corners, const Visit& visit) const
{
  constexpr std::size_t Deepest = 40; // halves of 2^31 points
  const Wedge wedge(corners, this->Nodes.front().box.sizes().maxCoeff());
  std::array<Index, Deepest> stack{};
  std::size_t size = 1;
  while (size > 0)
  {
    const Index number = stack[--size];
    const Node& node = this->Nodes[at(number)];
    if (node.left == 0 || !wedge.meets(node.box))
    {
      continue;
    }
    if (node.right != NoIndex)
    {
      stack[size++] = node.right;
      stack[size++] = number + 1;
      continue;
    }
    for (Index i = node.begin; i < node.end; ++i)
    {
      const Index point = this->Order[at(i)];
      if (!this->IsOut[at(point)] && visit(point))
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace evolving

#endif
