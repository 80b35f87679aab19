// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Closed surfaces of known shape and regular connectivity to start an evolution from.
 *
 * All are outward oriented, have no duplicate vertices and are numbered the same way on every
 * machine.
 */

#ifndef EVOLVING_PRIMITIVE_SURFACES_H
#define EVOLVING_PRIMITIVE_SURFACES_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

namespace evolving
{

/// The finest icosphere: 10,485,762 vertices.
constexpr int MaximumIcosphereLevel = 10;

/// The finest cube-sphere or box: 25,165,826 vertices.
constexpr int MaximumCubeDivisions = 2048;

/**
 * The regular icosahedron, every triangle cut into four at its edge midpoints `level` times, all
 * midpoints moved to the sphere: 10 * 4^level + 2 vertices, 20 * 4^level triangles.
 * The twelve vertices of the icosahedron keep valence 5, all others have 6.
 * @param level 0 to MaximumIcosphereLevel
 * @param radius of the circumscribed sphere, positive
 * @throws InputError when a parameter is out of range
 */
SurfaceMesh icosphere(int level, double radius = 1.0, const Vec3& centre = Vec3::Zero());

/**
 * A cube's surface projected onto the sphere, `divisions` quads along each side, cut at equal
 * angles (the gnomonic, equiangular cubed sphere; Ronchi, Iacono, Paolucci 1996):
 * 6 * divisions^2 + 2 vertices, 6 * divisions^2 quads.
 * @param divisions 1 to MaximumCubeDivisions
 * @param radius of the sphere, positive
 * @throws InputError when a parameter is out of range
 */
SurfaceMesh cubeSphere(int divisions, double radius = 1.0, const Vec3& centre = Vec3::Zero());

/**
 * The surface of an axis-aligned box, each side cut into divisions x divisions equal quads:
 * vertex and quad counts as cubeSphere().
 * @param divisions 1 to MaximumCubeDivisions
 * @param halfSides half the length along each axis, positive; the default is the unit cube
 * @throws InputError when a parameter is out of range
 */
SurfaceMesh subdividedBox(
  int divisions, const Vec3& halfSides = Vec3::Constant(0.5), const Vec3& centre = Vec3::Zero());

} // namespace evolving

#endif
