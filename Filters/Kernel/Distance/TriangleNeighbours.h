// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which triangles are beside which.
 */

#ifndef EVOLVING_TRIANGLE_NEIGHBOURS_H
#define EVOLVING_TRIANGLE_NEIGHBOURS_H

#include "Distance/AABBTree.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * For every triangle of a mesh those that share a vertex with it; for one that hangs together
 * with fewer than three (of a soup, or of a point set) those around it in space.
 */
class TriangleNeighbours
{
public:
  /// Around a vertex of more triangles than this they do not count as neighbours, for a fan of n
  /// triangles would make n^2 pairs; and no more than this are taken from space.
  static constexpr Index LargestFan = 24;

  /// @param mesh of triangles only, those of the tree
  /// @throws Cancelled
  TriangleNeighbours(
    const SurfaceMesh& mesh, const AABBTree& tree, const Execution& execution = {});

  const Index* begin(Index triangle) const { return this->first(triangle); }
  const Index* end(Index triangle) const { return this->first(triangle + 1); }

private:
  const Index* first(Index triangle) const
  {
    return this->Neighbours.data() + this->Offsets[static_cast<std::size_t>(triangle)];
  }
  void join(const std::vector<std::vector<Index>>& lists);

  std::vector<std::size_t> Offsets{ 0 };
  std::vector<Index> Neighbours;
};

} // namespace evolving

#endif
