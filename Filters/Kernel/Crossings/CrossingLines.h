// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The lines along which the triangles of a mesh cross, and where on each triangle they are.
 */

#ifndef EVOLVING_CROSSING_LINES_H
#define EVOLVING_CROSSING_LINES_H

#include "Crossings/CrossingPoints.h"
#include "Crossings/GridPoint.h"
#include "Execution.h"
#include "Mesh/BoxPairs.h"
#include "Mesh/SurfaceMesh.h"
#include "Mesh/TriangleEdges.h"
#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/**
 * Points have numbers: first the mesh's vertices, then where edges run through triangles, then
 * where three triangles cross. Segments are those of crossingPoints().
 */
class CrossingLines
{
public:
  /// As crossingPoints(); the mesh must outlive the lines.
  CrossingLines(
    const SurfaceMesh& mesh, const std::vector<IndexPair>& pairs, const Execution& execution = {});

  /// Are there more than can be cut with some patience? Then points of three triangles are left
  /// out: a soup of n large triangles has n^3 of them.
  bool areTooMany() const { return this->TooMany; }

  Index pointCount() const;
  const Vec3& point(Index number) const;
  /// A corner of a triangle, a point on a side of it or inside it, in its barycentric coordinates.
  GridPoint place(Index triangle, Index number) const;

  /// The points on the sides of a triangle, but for its corners.
  std::vector<Index> pointsOnSides(Index triangle) const;
  const std::vector<Index>& segmentsOf(Index triangle) const
  {
    return this->SegmentsOf[at(triangle)];
  }
  /// The points along a segment, its ends included.
  std::vector<Index> pointsAlong(Index segment) const;
  /// The triangles that a segment is on.
  const std::array<Index, 2>& trianglesOf(Index segment) const
  {
    return this->Crossings.segments[at(segment)].triangles;
  }
  /// Pairs of triangles that meet without a segment.
  const std::vector<IndexPair>& uncutPairs() const { return this->Crossings.uncut; }

private:
  /// Where three triangles cross, and the three segments that meet there.
  struct TriplePoint
  {
    Vec3 point = Vec3::Zero();
    std::array<Index, 3> segments{};
  };

  Index firstCrossing() const { return this->Mesh.vertexCount(); }
  Index firstTriple() const;
  const std::array<Index, 2>& endsOf(Index segment) const
  {
    return this->Crossings.segments[at(segment)].ends;
  }

  void sortSegments();
  void sortPoints();
  bool wouldBeTooMany() const;
  void addTriplePoints(const Execution& execution);
  std::vector<TriplePoint> triplePoints(Index triangle) const;
  Vec3 onSegment(Index segment, Index triangle) const;
  Index otherTriangle(Index segment, Index triangle) const;
  Index segmentOf(Index a, Index b) const;
  GridPoint atCorner(Index triangle, Index vertex) const;
  GridPoint onSide(Index triangle, Index k, std::int64_t along) const;
  GridPoint inTriangle(Index triangle, const Vec3& point) const;

  const SurfaceMesh& Mesh;
  TriangleEdges Edges;
  CrossingPoints Crossings;
  std::vector<std::vector<Index>> SegmentsOf; ///< of each triangle
  std::vector<Index> PointsOfEdge;            ///< of each edge, where its crossing points begin
  std::vector<TriplePoint> Triples;
  std::vector<std::vector<Index>> Between; ///< on each segment, by their place in Triples
  bool TooMany = false;
};

} // namespace evolving

#endif
