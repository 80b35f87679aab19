// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Closest points on a set of mesh edges.
 */

#ifndef EVOLVING_POLYLINE_TREE_H
#define EVOLVING_POLYLINE_TREE_H

#include "Features/TargetTriangles.h"
#include "Trees/AABBTree.h"
#include "Types.h"

#include <limits>
#include <vector>

namespace evolving
{

/// A point on an edge of the target.
struct EdgePoint
{
  Index edge = NoIndex; ///< NoIndex: there is none
  Vec3 point = Vec3::Zero();
  double squaredDistance = std::numeric_limits<double>::infinity();

  bool exists() const { return this->edge != NoIndex; }
};

/// An AABBTree of edges, each a triangle with two equal corners.
class PolylineTree
{
public:
  /// @param edges numbers in target.edges(); of several at the same distance the first answers
  PolylineTree(const TargetTriangles& target, std::vector<Index> edges);

  EdgePoint closest(const Vec3& point) const;
  /// As AABBTree::visitNear(): squaredBound = visit(edge).
  template <typename Visit>
  void visitNear(const Vec3& point, double squaredBound, const Visit& visit) const
  {
    this->Tree.visitNear(
      point, squaredBound, [&](Index segment) { return visit(this->Edges[at(segment)]); });
  }

private:
  std::vector<Index> Edges;
  AABBTree Tree;
};

} // namespace evolving

#endif
