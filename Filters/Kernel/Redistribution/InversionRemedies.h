// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What can be done about the moves of vertices whose faces would turn over.
 */

#ifndef EVOLVING_INVERSION_REMEDIES_H
#define EVOLVING_INVERSION_REMEDIES_H

#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving
{

/**
 * Adds to the moves of the faces' vertices the way along the surface to where the elements around
 * them are well shaped; one vertex after the other, for points of slivers, close together, would
 * all go the same way at once.
 * @param mesh at the points after the moves
 * @param normals of the vertices
 * @param[in,out] moves one per vertex
 */
void reshape(const SurfaceMesh& mesh, const MeshTopology& topology,
  const std::vector<Vec3>& normals, const std::vector<Index>& faces, std::vector<Vec3>& moves);

/// Gives the vertices of each face the mean of their moves; of several means, the mean.
void evenOut(const SurfaceMesh& mesh, const std::vector<Index>& faces, std::vector<Vec3>& moves);

/// Multiplies the fractions of the faces' vertices by a factor, each once.
void shorten(const SurfaceMesh& mesh, const std::vector<Index>& faces, double factor,
  std::vector<double>& fraction);

} // namespace evolving

#endif
