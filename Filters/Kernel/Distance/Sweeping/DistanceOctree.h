// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The cells of a grid that a surface passes through, found from the coarse to the fine, and the
 * exact distance at their centres (section 5.2 and algorithm 5 of the thesis).
 */

#ifndef EVOLVING_DISTANCE_OCTREE_H
#define EVOLVING_DISTANCE_OCTREE_H

#include "Distance/DistanceGrid.h"
#include "Execution.h"
#include "Trees/AABBTree.h"
#include "Types.h"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace evolving
{

/**
 * A cube of side h 2^k, h the spacing of a cubic grid, divided into eight wherever it meets a
 * triangle, down to cubes of side h whose centres are samples of the grid. Cells without a
 * sample of the grid are left out.
 *
 * The thesis gives a leaf the smallest distance to the triangles in it, which a triangle just
 * outside may undercut; here it is the distance to the nearest triangle of all.
 */
class DistanceOctree
{
public:
  struct Cell
  {
    std::array<int, 3> corner{ 0, 0, 0 }; ///< the sample in its lowest corner
    int side = 1;                         ///< in samples
  };

  /// A cell of the last level, with the triangle closest to its centre.
  struct Leaf
  {
    Cell cell;
    Index triangle = NoIndex;
    double squaredDistance = 0.0;
  };

  /**
   * @param maximumDepth stops the division earlier: leaves are larger then, and their centres
   * no samples
   * @param mostCells of a level
   * @throws InputError when the grid is not cubic, or a level has too many cells
   * @throws Cancelled
   */
  DistanceOctree(const AABBTree& tree, const DistanceGrid& grid, const Execution& execution = {},
    int maximumDepth = std::numeric_limits<int>::max(),
    std::size_t mostCells = std::numeric_limits<std::size_t>::max());

  /// 0 for an octree of the root alone; -1 when no triangle is in the grid.
  int depth() const { return static_cast<int>(this->Levels.size()) - 1; }
  /// The cells of a level that meet a triangle, the root's level being 0.
  const std::vector<Cell>& cells(int level) const
  {
    return this->Levels[static_cast<std::size_t>(level)];
  }
  const std::vector<Leaf>& leaves() const { return this->Leaves; }
  Box box(const Cell& cell) const;
  Vec3 center(const Cell& cell) const { return this->box(cell).center(); }

private:
  Box closure(const Cell& cell) const;
  void setRoot(const AABBTree& tree);
  bool hasSample(const Cell& cell) const;
  std::vector<Cell> openChildren(
    const AABBTree& tree, const std::vector<Cell>& parents, const Execution& execution) const;
  void measureLeaves(const AABBTree& tree, const Execution& execution);

  DistanceGrid Grid;
  std::vector<std::vector<Cell>> Levels;
  std::vector<Leaf> Leaves;
};

} // namespace evolving

#endif
