// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Who is beside whom: opposite corners, sorted one-rings, boundary loops, components.
 *
 * Algorithms 1 and 3 of the thesis, on a corner table: corner c stands for the directed edge
 * from its vertex to the vertex of the next corner of its face.
 */

#ifndef EVOLVING_MESH_TOPOLOGY_H
#define EVOLVING_MESH_TOPOLOGY_H

#include "Mesh/SurfaceMesh.h"
#include "Mesh/TopologySummary.h" // for callers: both names belong to one question
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * The adjacency of an oriented manifold mesh, closed or with boundary. Constant while the faces
 * are; points may move.
 */
class MeshTopology
{
public:
  /// A run of corners or vertices inside an array of this class.
  struct Run
  {
    const Index* first;
    const Index* last;
    const Index* begin() const { return this->first; }
    const Index* end() const { return this->last; }
    Index size() const { return static_cast<Index>(this->last - this->first); }
    Index operator[](Index i) const { return this->first[i]; }
  };

  /**
   * @throws InputError when an edge belongs to more than two faces or to two that disagree in
   * orientation, when several fans of faces meet at a vertex (the thesis, end of 4.2.1), or when
   * an edge joins a vertex to itself.
   */
  explicit MeshTopology(const SurfaceMesh& mesh);

  Index vertexCount() const { return static_cast<Index>(this->RingOffsets.size()) - 1; }
  Index faceCount() const { return static_cast<Index>(this->FaceOffsets.size()) - 1; }
  Index cornerCount() const { return static_cast<Index>(this->Vertex.size()); }

  Index vertexOf(Index corner) const { return this->Vertex[at(corner)]; }
  Index faceOf(Index corner) const { return this->Face[at(corner)]; }
  Index next(Index corner) const;
  Index previous(Index corner) const;
  /// The corner that stands for the same edge in the other direction; NoIndex at the boundary.
  Index opposite(Index corner) const { return this->Opposite[at(corner)]; }

  /**
   * The corners at a vertex, counter-clockwise (algorithm 3). At a boundary vertex they run
   * from the first boundary edge (whose corner has no opposite) to the last.
   */
  Run ringCorners(Index vertex) const;
  /**
   * The vertices joined to a vertex by an edge, counter-clockwise; one more than corners at a
   * boundary vertex.
   */
  Run ringVertices(Index vertex) const;
  bool isBoundary(Index vertex) const { return this->BoundaryVertex[at(vertex)] != 0; }
  bool isUsed(Index vertex) const { return this->ringCorners(vertex).size() > 0; }

  /// Each boundary curve as the vertices along it, the surface on the left.
  const std::vector<std::vector<Index>>& boundaryLoops() const { return this->Loops; }

  /// The component of every vertex, numbered by smallest vertex; NoIndex for unused vertices.
  const std::vector<Index>& componentOfVertex() const { return this->Component; }
  Index componentCount() const { return this->Components; }

private:
  void joinOpposites(const SurfaceMesh& mesh);
  std::vector<Index> findRingStarts();
  void sortRings();
  void walkRing(Index start);
  void traceBoundaryLoops();

  std::vector<Index> FaceOffsets;
  std::vector<Index> Vertex;
  std::vector<Index> Face;
  std::vector<Index> Opposite;
  std::vector<Index> RingOffsets;
  std::vector<Index> RingCorner;
  std::vector<Index> NeighbourOffsets;
  std::vector<Index> Neighbour;
  std::vector<char> BoundaryVertex;
  std::vector<std::vector<Index>> Loops;
  std::vector<Index> Component;
  Index Components = 0;
};

} // namespace evolving

#endif
