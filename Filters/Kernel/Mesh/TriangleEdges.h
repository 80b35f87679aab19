// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The edges of any triangle mesh, however dirty: which corners run along each.
 */

#ifndef EVOLVING_TRIANGLE_EDGES_H
#define EVOLVING_TRIANGLE_EDGES_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <utility>
#include <vector>

namespace evolving
{

/**
 * Corner c of a triangle mesh is corner c % 3 of face c / 3 and stands for the directed edge
 * from its vertex to the next corner's. Corners along the same undirected edge share an edge
 * number. Unlike MeshTopology this accepts any number of faces at an edge, in any direction.
 */
class TriangleEdges
{
public:
  /// @param mesh of triangles only
  explicit TriangleEdges(const SurfaceMesh& mesh);

  /// After some faces were turned, which exchanged their last two corners' vertices: the edges
  /// stay, with their numbers, but other corners run along them.
  void turn(const std::vector<char>& isTurned);

  Index edgeCount() const { return static_cast<Index>(this->Offsets.size()) - 1; }
  /// The edge number of every corner, when that is all one still needs.
  std::vector<Index> takeEdgeOfCorner() && { return std::move(this->EdgeOfCorner); }
  Index edgeOf(Index corner) const { return this->EdgeOfCorner[at(corner)]; }

  /// The corners along an edge, in ascending order.
  const Index* begin(Index edge) const { return this->Corners.data() + this->Offsets[at(edge)]; }
  const Index* end(Index edge) const { return this->Corners.data() + this->Offsets[at(edge) + 1]; }
  Index faceCount(Index edge) const
  {
    return static_cast<Index>(this->end(edge) - this->begin(edge));
  }

  /// Does a corner run from the smaller to the larger vertex number?
  static bool runsUpwards(const SurfaceMesh& mesh, Index corner);
  static Index nextCorner(Index corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

private:
  std::vector<Index> EdgeOfCorner;
  std::vector<Index> Offsets{ 0 };
  std::vector<Index> Corners;
};

} // namespace evolving

#endif
