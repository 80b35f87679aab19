// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A tree for the question "which is closest" over needles that lie side by side.
 */

#ifndef EVOLVING_NEEDLE_TREE_H
#define EVOLVING_NEEDLE_TREE_H

#include "Trees/NearestFirst.h"
#include "Trees/OrientedBox.h"
#include "Trees/TriangleGeometry.h"
#include "Types.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace evolving
{

/// Some boxes, turned as they fit, side by side.
class TurnedBoxes
{
public:
  static constexpr int Length = 8;
  using Lanes = Eigen::Array<double, Length, 1>;

  void set(int place, const OrientedBox& box, double margin);

  /// The squared distances from a point to the boxes; 0 inside.
  Lanes squaredGaps(const Vec3& point) const
  {
    const Lanes x = point.x() - this->Center[0];
    const Lanes y = point.y() - this->Center[1];
    const Lanes z = point.z() - this->Center[2];
    Lanes sum = Lanes::Zero();
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Lanes along = this->Axis[k][0] * x + this->Axis[k][1] * y + this->Axis[k][2] * z;
      sum += (along.abs() - this->HalfSize[k]).max(0.0).square();
    }
    return sum;
  }

private:
  using Three = std::array<Lanes, 3>;

  static Three zeros() { return { Lanes::Zero(), Lanes::Zero(), Lanes::Zero() }; }

  Three Center = zeros();
  std::array<Three, 3> Axis = { zeros(), zeros(), zeros() };
  Three HalfSize = zeros(); ///< with the margin
};

/**
 * Long thin triangles side by side in any direction but those of the axes have boxes that all lie
 * on each other, and cutting them short takes as many pieces as they are times longer than wide.
 * Boxes turned along them do not. Triangles are cut in halves of equal number along the longest
 * axis of their centroids' box, three times for one node.
 */
class NeedleTree
{
public:
  NeedleTree() = default;
  /// @param chosen numbers of those that are to be in the tree
  NeedleTree(const std::vector<Triangle>& triangles, std::vector<Index> chosen);

  /// As WideBoxTree::visitNear(), and each triangle once at most.
  template <typename Visit>
  void visitNear(const Vec3& point, double squaredBound, const Visit& visit) const;

private:
  friend class NeedleTreeBuilder;

  struct Node
  {
    TurnedBoxes boxes;
    std::array<Index, TurnedBoxes::Length> children{}; ///< as visitNearestFirst() has them
    int childCount = 0;
  };
  /// Halves of 2^32 triangles, three to a level.
  static constexpr std::size_t MostLevels = 12;
  static constexpr std::size_t MostPending = (TurnedBoxes::Length - 1) * MostLevels + 1;

  std::vector<Node> Nodes;
  Vec3 Origin = Vec3::Zero(); ///< from where the boxes count
};

template <typename Visit>
void NeedleTree::visitNear(const Vec3& point, double squaredBound, const Visit& visit) const
{
  constexpr double Rounding = 1.0 - 1e-12; // of a gap, far above that of its dozen operations
  const Vec3 p = point - this->Origin;
  visitNearestFirst<MostPending>(
    this->Nodes, squaredBound,
    [&](const Node& node) -> TurnedBoxes::Lanes { return Rounding * node.boxes.squaredGaps(p); },
    visit);
}

} // namespace evolving

#endif
