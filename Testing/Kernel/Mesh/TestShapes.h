// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Shapes with known answers for the tests of the mesh folder.
 */

#ifndef EVOLVING_TEST_SHAPES_H
#define EVOLVING_TEST_SHAPES_H

#include "Mesh/SurfaceMesh.h"

#include <array>
#include <set>
#include <vector>

namespace evolving
{

/// A mesh of the given points and faces.
SurfaceMesh makeMesh(const std::vector<Vec3>& points, const std::vector<std::vector<Index>>& faces);

/// The corner of the unit cube with three right angles at the origin; volume 1/6.
SurfaceMesh cornerTetrahedron();

/// The cube [0, 1]^3 as six quads.
SurfaceMesh unitCube();

/// A regular icosahedron split level times, on the unit sphere: 20 * 4^level triangles.
SurfaceMesh unitIcosphere(int level);

/// Quads, around segments along the ring and across segments around the tube.
SurfaceMesh torus(Index around, Index across, double ringRadius, double tubeRadius);

/// A flat ring of quads between radius 1 and 2, two loops of count vertices.
SurfaceMesh annulus(Index count);

/// Triangles around vertex 0 in the plane z = 0.
SurfaceMesh disc(Index count);

/// A strip of count quads, closed after half a turn.
SurfaceMesh moebiusBand(Index count);

/// The quads between the cells (unit cubes with integer corners) and the rest of space.
SurfaceMesh cellSurface(const std::set<std::array<int, 3>>& cells);

/// A slab of cells with the given number of holes through it: genus = holes.
SurfaceMesh slabWithHoles(int holes);

/// rows by columns points (i, j, 0), each square cut into two triangles.
SurfaceMesh triangleSheet(Index rows, Index columns);

} // namespace evolving

#endif
