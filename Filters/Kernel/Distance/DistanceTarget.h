// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A mesh made ready to measure distances to.
 */

#ifndef EVOLVING_DISTANCE_TARGET_H
#define EVOLVING_DISTANCE_TARGET_H

#include "Distance/Signs/OutwardOrientation.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <vector>

namespace evolving
{

struct DistanceTarget
{
  SurfaceMesh mesh; ///< triangles relative to the centre; of points, three equal corners
  std::vector<Index> oldNumber; ///< of each triangle: the input's face, or point of a point set
  Vec3 center = Vec3::Zero();   ///< of the input's bounding box
  bool isPointSet = false;
  OrientationSummary orientation; ///< of a surface
};

/**
 * Joins coincident points, cuts polygons into triangles and keeps one of several triangles with
 * the same corners. The mesh must have passed validate().
 * @param[out] oldFace for every triangle the face it comes from
 * @throws InputError when no face has three different corners
 * @throws Cancelled between these steps
 */
SurfaceMesh uniqueTriangles(
  const SurfaceMesh& mesh, std::vector<Index>& oldFace, const Execution& execution = {});

/**
 * Joins coincident points, cuts polygons into triangles, keeps one of several triangles with
 * the same corners, moves the mesh to its centre and turns its triangles outwards. Of a mesh
 * without faces, the different points.
 * @throws InputError when the mesh is empty or damaged, no face has three different corners, or
 * it is larger than 1e31 or smaller than 1e-31
 * @throws Cancelled between these steps
 */
DistanceTarget makeDistanceTarget(const SurfaceMesh& mesh, const Execution& execution = {});

} // namespace evolving

#endif
