// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Closed surfaces of few flat faces, and meshes given by their faces.
 */

#ifndef EVOLVING_TESTING_POLYHEDRA_H
#define EVOLVING_TESTING_POLYHEDRA_H

#include "Mesh/SurfaceMesh.h"

#include <array>
#include <set>
#include <vector>

namespace evolving::shapes
{

/// A mesh of the given points and faces.
SurfaceMesh makeMesh(const std::vector<Vec3>& points, const std::vector<std::vector<Index>>& faces);

/// One triangle.
SurfaceMesh triangleMesh(const Vec3& a, const Vec3& b, const Vec3& c);

/// The corner of the unit cube with three right angles at the origin; volume 1/6.
SurfaceMesh cornerTetrahedron();

/// Four corners of the cube [-1, 1]^3.
SurfaceMesh regularTetrahedron();

/// Its corners on the axes, at distance 1.
SurfaceMesh octahedron();

/// The cube [0, 1]^3 as six quads.
SurfaceMesh unitCube();

/// A box of 12 triangles.
SurfaceMesh box(const Vec3& low, const Vec3& high);

/// The box from -halfSides to halfSides: 2 * divisions^2 triangles a side.
SurfaceMesh triangleBox(int divisions, const Vec3& halfSides);

/// A closed prism over a regular hexagon: two hexagons and six quads.
SurfaceMesh hexagonalPrism();

/// The quads between the cells (unit cubes with integer corners) and the rest of space.
SurfaceMesh cellSurface(const std::set<std::array<int, 3>>& cells);

/// A slab of cells with the given number of holes through it: genus = holes.
SurfaceMesh slabWithHoles(int holes);

} // namespace evolving::shapes

#endif
