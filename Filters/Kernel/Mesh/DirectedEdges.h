// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The edges of the faces, sorted so that the faces at one edge stand side by side.
 */

#ifndef EVOLVING_DIRECTED_EDGES_H
#define EVOLVING_DIRECTED_EDGES_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <cstddef>
#include <vector>

namespace evolving
{

/// An edge as one face runs along it, under its undirected name (low, high).
struct DirectedEdge
{
  Index low;
  Index high;
  Index corner; ///< where it begins
  Index end;    ///< the next corner of the face, where it ends
  bool forward; ///< runs from low to high

  bool sameEdge(const DirectedEdge& other) const
  {
    return this->low == other.low && this->high == other.high;
  }
  Index cornerAtLow() const { return this->forward ? this->corner : this->end; }
  Index cornerAtHigh() const { return this->forward ? this->end : this->corner; }
};

/// One directed edge per corner, by low vertex, then high vertex, then corner.
std::vector<DirectedEdge> sortedDirectedEdges(const SurfaceMesh& mesh);

/// Calls visit(first, last) for each run of sorted directed edges with the same undirected edge.
template <typename Visit>
void forEachEdge(const std::vector<DirectedEdge>& edges, const Visit& visit)
{
  for (std::size_t first = 0; first < edges.size();)
  {
    std::size_t last = first + 1;
    while (last < edges.size() && edges[last].sameEdge(edges[first]))
    {
      ++last;
    }
    visit(first, last);
    first = last;
  }
}

} // namespace evolving

#endif
