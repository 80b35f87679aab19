// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Angle-weighted pseudonormals (algorithm 2 of the thesis).
 */

#ifndef EVOLVING_VERTEX_NORMALS_H
#define EVOLVING_VERTEX_NORMALS_H

#include "Execution.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving
{

/**
 * Unit normals at the vertices: the sum of the incident faces' unit normals, each weighted by
 * the face's interior angle at the vertex (Baerentzen, Aanaes 2005). So they do not depend on how
 * flat parts are cut into polygons. A vertex without a face of positive area gets the zero vector.
 * @return one vector per vertex
 */
std::vector<Vec3> angleWeightedNormals(
  const SurfaceMesh& mesh, const MeshTopology& topology, const Execution& execution = {});

/// The same for a mesh without a topology (any soup): one pass over all corners, serial.
std::vector<Vec3> angleWeightedNormals(const SurfaceMesh& mesh);

} // namespace evolving

#endif
