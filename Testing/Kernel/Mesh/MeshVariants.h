// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The same surface in other words: moved, cut, shuffled, taken apart. For the tests.
 */

#ifndef EVOLVING_MESH_VARIANTS_H
#define EVOLVING_MESH_VARIANTS_H

#include "Mesh/SurfaceMesh.h"

#include <random>
#include <vector>

namespace evolving
{

/// Every polygon cut into a fan of triangles about a corner chosen at random.
SurfaceMesh triangulated(const SurfaceMesh& mesh, std::mt19937& generator);

/// Every face with points of its own, as in an STL file.
SurfaceMesh soupOf(const SurfaceMesh& mesh);

/// Both meshes side by side, no vertex shared.
SurfaceMesh unionOf(const SurfaceMesh& first, const SurfaceMesh& second);

/// The mesh with the points mapped by p -> scale * p + offset.
SurfaceMesh moved(SurfaceMesh mesh, double scale, const Vec3& offset);

/// The mesh with every face's corners in reversed order.
SurfaceMesh flipped(const SurfaceMesh& mesh);

/// A point in the cube [-1, 1]^3.
Vec3 randomPoint(std::mt19937& generator);

/// A rotation about a random axis by a random angle.
Eigen::Matrix3d randomRotation(std::mt19937& generator);

/// The mesh with every point multiplied by a matrix.
SurfaceMesh mapped(SurfaceMesh mesh, const Eigen::Matrix3d& matrix);

/// The same surface with vertices, faces and the corners of each face in another order.
SurfaceMesh shuffled(const SurfaceMesh& mesh, std::mt19937& generator);

} // namespace evolving

#endif
