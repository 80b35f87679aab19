// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Turns the triangles of a mesh so that "outside" means the same everywhere.
 */

#ifndef EVOLVING_OUTWARD_ORIENTATION_H
#define EVOLVING_OUTWARD_ORIENTATION_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/// What kind of surface a triangle mesh is once it has been turned.
struct OrientationSummary
{
  Index turnedFaces = 0;
  Index components = 0;           ///< connected through edges of two faces
  Index boundaryEdges = 0;        ///< edges of one face
  Index nonManifoldEdges = 0;     ///< edges of more than two faces
  Index conflictingEdges = 0;     ///< edges whose two faces still disagree: a one-sided surface
  bool componentsOverlap = false; ///< do the boxes of two components intersect?
  double openLength = 0.0;        ///< of the edges along which directed faces do not cancel
  /// These edges, from vertex to vertex as the faces run that nothing cancels, once for each face.
  std::vector<std::array<Index, 2>> openEdges;
  /// Of every corner, see TriangleEdges: kept because the pseudonormals need it too.
  std::vector<Index> edgeOfCorner;

  bool isClosed() const { return this->boundaryEdges == 0 && this->nonManifoldEdges == 0; }
  bool isOriented() const { return this->conflictingEdges == 0; }
};

/**
 * Gives neighbours the same orientation and closed components their outside:
 * - faces that share an edge of two faces are made to agree, by turning the smaller area;
 * - a closed component that lies in no other gets a positive volume, and what lies inside it is
 *   turned with it, so that a cavity stays a cavity;
 * - an open component is turned when it encloses clearly negative volume about its centre.
 * @param mesh of triangles only; corner order is changed, face numbers are not
 */
OrientationSummary orientOutwards(SurfaceMesh& mesh);

} // namespace evolving

#endif
