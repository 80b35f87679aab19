// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * On which side of a closed surface a point lies, from its closest point alone.
 */

#ifndef EVOLVING_PSEUDONORMALS_H
#define EVOLVING_PSEUDONORMALS_H

#include "Mesh/SurfaceMesh.h"
#include "Trees/TriangleGeometry.h"

#include <vector>

namespace evolving
{

/**
 * A normal for every face, edge and vertex of a triangle mesh: at an edge the sum of the unit
 * normals of its faces, at a vertex their sum weighted by angle. For a closed oriented surface
 * the sign of (x - c).n, c the point closest to x and n the normal of the feature c lies on, is
 * positive outside and negative inside (Baerentzen, Aanaes, Signed Distance Computation Using
 * the Angle Weighted Pseudonormal, 2005).
 */
class Pseudonormals
{
public:
  /**
   * Both are read as long as the pseudonormals are used.
   * @param mesh of triangles only
   * @param edgeOfCorner of this mesh, see TriangleEdges
   */
  Pseudonormals(const SurfaceMesh& mesh, const std::vector<Index>& edgeOfCorner);

  /// The normal at a feature of a face; not of unit length, zero where no face has an area.
  const Vec3& at(Index face, TriangleFeature feature) const;
  /// Is the point behind its closest point on a face? A point on the surface is not.
  bool isInside(const Vec3& point, Index face, const TrianglePoint& closest) const;

private:
  const SurfaceMesh& Mesh;
  const std::vector<Index>& EdgeOfCorner;
  std::vector<Vec3> OfFace;
  std::vector<Vec3> OfEdge;
  std::vector<Vec3> OfVertex;
};

} // namespace evolving

#endif
