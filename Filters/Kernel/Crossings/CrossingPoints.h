// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Where the edges of a mesh run through its triangles.
 */

#ifndef EVOLVING_CROSSING_POINTS_H
#define EVOLVING_CROSSING_POINTS_H

#include "Execution.h"
#include "Mesh/BoxPairs.h"
#include "Mesh/SurfaceMesh.h"
#include "Mesh/TriangleEdges.h"
#include "Types.h"

#include <array>
#include <cstdint>
#include <vector>

namespace evolving
{

/// Where an edge runs through the inside of a triangle.
struct CrossingPoint
{
  Index edge = NoIndex;
  Index triangle = NoIndex;
  std::int64_t along = 0; ///< from the edge's vertex with the smaller number, see GridPoint
  Vec3 point = Vec3::Zero();
};

/// What two triangles have in common that run through each other.
struct CrossingSegment
{
  std::array<Index, 2> triangles{}; ///< the smaller number first
  /// Numbers of points: the mesh's vertices, then the crossing points. A vertex is an end where
  /// both triangles have it.
  std::array<Index, 2> ends{};
};

struct CrossingPoints
{
  std::vector<CrossingPoint> points;     ///< sorted by edge and triangle, each once
  std::vector<CrossingSegment> segments; ///< sorted by triangles
  std::vector<IndexPair> uncut;          ///< pairs that have no segment, sorted
};

/**
 * Which edges run through which triangles is exact, so neighbours agree on it; where is rounded.
 * Of triangles that share a vertex the segment begins there. Pairs that only touch, or lie on each
 * other, as those that share an edge do, have none.
 * @param mesh triangles
 * @param pairs of triangles that may cross, sorted
 * @throws Cancelled
 */
CrossingPoints crossingPoints(const SurfaceMesh& mesh, const TriangleEdges& edges,
  const std::vector<IndexPair>& pairs, const Execution& execution = {});

} // namespace evolving

#endif
