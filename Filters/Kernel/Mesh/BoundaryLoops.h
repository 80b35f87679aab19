// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The boundary curves of a mesh in any state, and how large they are.
 */

#ifndef EVOLVING_BOUNDARY_LOOPS_H
#define EVOLVING_BOUNDARY_LOOPS_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// A closed curve of edges that belong to one face each.
struct BoundaryLoop
{
  /// Each vertex once. Along most of its length the faces at it run in the same direction.
  std::vector<Index> vertices;
  double perimeter = 0.0;
  double diameter = 0.0;          ///< the largest distance of two of the vertices
  Vec3 vectorArea = Vec3::Zero(); ///< of any cap that runs along the loop; the area of a flat one
  /// How the surface goes on across the loop: the mean over its length of the cosine of the angle
  /// between the faces' normals and a flat cap's. 1 for a hole in a plane, 0 for the rim of a tube
  /// or a hemisphere, -1 for the outline of a flat sheet, whose cap would lie on the sheet itself.
  double continuation = 0.0;
};

/**
 * The mesh's boundary cycles (BoundaryCycles.h) by their smallest vertex, measured. For welded
 * meshes in any state: orientation is not trusted, edges of many faces are no boundary.
 */
std::vector<BoundaryLoop> boundaryLoops(const SurfaceMesh& mesh);

} // namespace evolving

#endif
