// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A tree of oriented boxes over triangles, eight to a node, laid out so that the eight are tested
 * side by side.
 */

#ifndef EVOLVING_ORIENTED_BOX_TREE_H
#define EVOLVING_ORIENTED_BOX_TREE_H

#include "Distance/ClosestPoint/FramedTriangle.h"
#include "Execution.h"
#include "Types.h"

#include <cstdint>
#include <vector>

namespace evolving
{

/// Up to eight oriented boxes, number by number side by side.
struct alignas(32) BoxFan
{
  static constexpr int Width = 8;

  float center[3][Width] = {};
  float axis[3][3][Width] = {};  ///< three unit vectors a box
  float halfSize[3][Width] = {}; ///< along them, with the margin
  float longestSide[Width] = {};
  /// What is in a box: another fan, or in a leaf a triangle of OrientedBoxTree::triangles().
  Index child[Width] = {};
  int count = 0;
  bool isLeaf = false;

  std::uint32_t allBoxes() const { return (1U << this->count) - 1U; }
};

/**
 * Triangles are cut in halves of equal number along the longest axis of their centroids' box,
 * three times for one fan. Small groups of triangles are nearly flat, and a box turned into their
 * plane fits them far more closely than an axis-aligned one does: what a search for the closest
 * triangle can rule out depends on just that.
 */
class OrientedBoxTree
{
public:
  /**
   * @param triangles in any unit of length of the caller's
   * @param margin added to the boxes' half sizes, above the rounding of coordinates to floats
   * @throws Cancelled
   */
  OrientedBoxTree(
    const std::vector<Triangle>& triangles, double margin, const Execution& execution = {});

  /// The root is the first; parents come before their children.
  const std::vector<BoxFan>& fans() const { return this->Fans; }
  /// In the order of the leaves; each knows its number in the constructor's list.
  const std::vector<FramedTriangle>& triangles() const { return this->Framed; }

private:
  std::vector<BoxFan> Fans;
  std::vector<FramedTriangle> Framed;
};

} // namespace evolving

#endif
