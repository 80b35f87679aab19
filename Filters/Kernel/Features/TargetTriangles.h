// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A target surface as triangles with edges, made ready to ask what is sharp on it.
 */

#ifndef EVOLVING_TARGET_TRIANGLES_H
#define EVOLVING_TARGET_TRIANGLES_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Mesh/TriangleEdges.h"
#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/**
 * Any surface, closed or not, manifold or not, with its faces turned to any side. Constant after
 * construction.
 */
class TargetTriangles
{
public:
  /**
   * Joins coincident points, cuts polygons, keeps one of several triangles with the same corners.
   * @throws InputError when no face has three different corners or the mesh is damaged
   * @throws Cancelled
   */
  explicit TargetTriangles(const SurfaceMesh& surface, const Execution& execution = {});

  const SurfaceMesh& mesh() const { return this->Mesh; }
  const TriangleEdges& edges() const { return this->Edges; }
  /// For every triangle the face of the input that it comes from.
  const std::vector<Index>& oldFace() const { return this->OldFace; }

  /// The vertices of an edge, the smaller number first.
  std::array<Index, 2> edgeVertices(Index edge) const;
  double edgeLength(Index edge) const;
  const Vec3& point(Index vertex) const { return this->Mesh.points[at(vertex)]; }

  /// The faces at an edge are those of edges().begin(edge) ... edges().end(edge), by corner / 3.
  static Index faceOf(Index corner) { return corner / 3; }
  Index edgeOfFace(Index face, Index k) const { return this->Edges.edgeOf(3 * face + k); }
  /// Calls visit(other face) for the other faces at edge k of a face.
  template <typename Visit>
  void forEachFaceAcross(Index face, Index k, const Visit& visit) const
  {
    const Index edge = this->edgeOfFace(face, k);
    for (const Index* c = this->Edges.begin(edge); c != this->Edges.end(edge); ++c)
    {
      if (faceOf(*c) != face)
      {
        visit(faceOf(*c));
      }
    }
  }

  /// The triangles at a vertex, ascending.
  const Index* facesBegin(Index vertex) const;
  const Index* facesEnd(Index vertex) const;

private:
  static SurfaceMesh clean(
    const SurfaceMesh& surface, std::vector<Index>& oldFace, const Execution& execution);
  void sortFacesByVertex();

  std::vector<Index> OldFace;
  SurfaceMesh Mesh;
  TriangleEdges Edges;
  std::vector<Index> FaceOffsets; ///< per vertex, into FacesOfVertices
  std::vector<Index> FacesOfVertices;
};

} // namespace evolving

#endif
