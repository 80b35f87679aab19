// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The generalized winding number of a triangle soup: 1 inside, 0 outside, and in between where
 * the surface has holes.
 */

#ifndef EVOLVING_WINDING_NUMBER_H
#define EVOLVING_WINDING_NUMBER_H

#include "Execution.h"
#include "Trees/TriangleGeometry.h"
#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/// The solid angle of a triangle seen from a point over 4 pi, positive from behind
/// (van Oosterom, Strackee, 1983).
double windingNumber(const Triangle& triangle, const Vec3& point);

/**
 * The sum over all triangles by a tree: triangles near the point exactly, groups farther than
 * `Accuracy` times their radius by their expansion up to second derivatives (Barill et al.,
 * Fast Winding Numbers for Soups and Clouds, 2018).
 */
class WindingNumber
{
public:
  static constexpr double Accuracy = 2.0;
  /// A bound for the error of the expansion, as met on any input tried; not a proven one.
  static constexpr double Tolerance = 0.02;

  /// @throws Cancelled
  explicit WindingNumber(const std::vector<Triangle>& triangles, const Execution& execution = {});

  double at(const Vec3& point) const;

private:
  using Matrix = Eigen::Matrix3d;

  /// A group of triangles and what the expansion about its centre needs of their moments.
  struct Node
  {
    Vec3 center = Vec3::Zero();      ///< area-weighted
    double squaredReach = 0.0;       ///< squared distance from which the expansion is good
    Vec3 area = Vec3::Zero();        ///< sum of the area vectors a
    Matrix first = Matrix::Zero();   ///< integral of x a^T, x relative to the centre
    Vec3 secondTrace = Vec3::Zero(); ///< the traces of the second moments
    std::array<Matrix, 3> second{};  ///< half the integral of x x^T a_k, for k = 0, 1, 2
    Index right = NoIndex;           ///< NoIndex for leaves; the left child follows its parent
    Index begin = 0;
    Index end = 0;
  };

  /// Triangles [begin, end) in the order of the leaves.
  struct Range
  {
    Index begin = 0;
    Index end = 0;

    Index middle() const { return this->begin + (this->end - this->begin) / 2; }
  };

  /// The topmost nodes are split one after the other, what is below them side by side.
  int topLevels() const;
  std::vector<Range> splitTop();
  /// Adds a topmost node and all below it, from the finished parts in their order; collects the
  /// nodes whose moments are still to be filled.
  Index addTop(const Range& range, int levels,
    std::vector<std::vector<Node>>::const_iterator& subtree, std::vector<Index>& top);
  Index addNode(const Range& range, std::vector<Node>& nodes);
  void fillMoments(Node& node) const;
  static double expansion(const Node& node, const Vec3& toCenter, double squaredDistance);

  std::vector<Triangle> Triangles; ///< in the order of the leaves
  std::vector<Node> Nodes;
};

} // namespace evolving

#endif
