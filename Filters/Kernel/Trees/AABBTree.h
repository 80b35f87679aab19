// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A binary tree of boxes over triangles that answers "which is closest", "which meet this box"
 * and "which does this ray cross" (section 5.1 of the thesis).
 */

#ifndef EVOLVING_AABB_TREE_H
#define EVOLVING_AABB_TREE_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Trees/BoxNode.h"
#include "Trees/MeasuredTriangle.h"
#include "Trees/NeedleTree.h"
#include "Trees/Ray.h"
#include "Trees/TriangleGeometry.h"
#include "Trees/WideBoxTree.h"
#include "Types.h"

#include <limits>
#include <vector>

namespace evolving
{

/// The answer to "which triangle is closest".
struct ClosestTriangle
{
  Index triangle = NoIndex; ///< NoIndex: none within the bound
  TrianglePoint at;
};

/// A triangle crossed by a ray, at origin + parameter * direction.
struct RayHit
{
  Index triangle = NoIndex;
  double parameter = 0.0;
  bool isFromBehind = false;
};

/**
 * Boxes are split at their longest axis where the surface area heuristic is lowest; a triangle
 * may lie in both halves. A half is shrunk to what its triangles fill of it. A point set is a
 * mesh whose triangles have three equal corners.
 */
class AABBTree
{
public:
  /// The conditions under which a box is split.
  static constexpr int MaximumDepth = BoxNode::MostLevels - 1;
  static constexpr int LargestLeaf = 2;
  static constexpr double LargestGrowth = 1.5; ///< of N_L + N_R over N

  using Node = BoxNode;

  /**
   * @param mesh of triangles only; copied in
   * @throws InputError when a face is not a triangle
   * @throws Cancelled
   */
  explicit AABBTree(const SurfaceMesh& mesh, const Execution& execution = {});

  bool isEmpty() const { return this->Triangles.empty(); }
  Index triangleCount() const { return static_cast<Index>(this->Triangles.size()); }
  const Triangle& triangle(Index i) const { return this->Triangles[static_cast<std::size_t>(i)]; }
  const std::vector<Triangle>& triangles() const { return this->Triangles; }

  /// The smallest box of the triangles.
  Box bounds() const;

  /// The nodes in one array, parents before children, the root first; empty without triangles.
  const std::vector<Node>& nodes() const { return this->Nodes; }
  /// The depth of a node; the root's is 0.
  int level(Index node) const { return this->Levels[static_cast<std::size_t>(node)]; }
  /// The triangles of all leaves one after the other; a leaf's are in ascending order.
  const std::vector<Index>& leafTriangles() const { return this->LeafTriangles; }

  /**
   * The triangle closest to a point, by MeasuredTriangle::squaredDistance(); of several at the
   * same distance the one with the smallest number, so that the answer does not depend on the
   * bound or the guess.
   * @param squaredBound triangles farther than its root are not found
   * @param guess a triangle that may be close, for speed; a number of none (NoIndex, or one of a
   *   tree before this one) is no guess
   */
  ClosestTriangle closest(const Vec3& point,
    double squaredBound = std::numeric_limits<double>::infinity(), Index guess = NoIndex) const;

  /**
   * Calls squaredBound = visit(triangle) for those that may be as near to a point as the bound says
   * then, and for others: near ones first, some more than once. A negative bound ends it.
   */
  template <typename Visit>
  void visitNear(const Vec3& point, double squaredBound, const Visit& visit) const
  {
    double bound = squaredBound;
    const auto visitAndKeep = [&](Index triangle) { return bound = visit(triangle); };
    this->Near.visitNear(point, bound, visitAndKeep);
    this->Needles.visitNear(point, bound, visitAndKeep);
  }

  /// Does a triangle have a point in common with a closed box?
  bool meets(const Box& box) const;
  /// The triangles that have, in ascending order.
  std::vector<Index> trianglesIn(const Box& box) const;

  /// The triangles a ray crosses, in ascending order of parameter.
  std::vector<RayHit> hits(const Ray& ray) const;

private:
  friend class AABBTreeBuilder;

  double squaredDistance(Index triangle, const Vec3& point) const
  {
    return this->Measured[static_cast<std::size_t>(triangle)].squaredDistance(point);
  }

  std::vector<Triangle> Triangles;
  std::vector<MeasuredTriangle<double>> Measured;
  std::vector<Node> Nodes;
  std::vector<std::int8_t> Levels;
  std::vector<Index> LeafTriangles;
  ///@{
  /// The same for closest(); what is in leaves of many, which could not be split, in the second.
  WideBoxTree Near;
  NeedleTree Needles;
  ///@}
};

} // namespace evolving

#endif
