// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Surfaces of genus 0 about the origin: spheres, whole or not, and what becomes of them.
 */

#ifndef EVOLVING_TESTING_SPHERES_H
#define EVOLVING_TESTING_SPHERES_H

#include "Mesh/SurfaceMesh.h"

namespace evolving::shapes
{

/// An octahedron whose triangles were divided into four `level` times, points on the sphere.
SurfaceMesh sphere(int level, double radius = 1.0, const Vec3& center = Vec3::Zero());

/// A regular icosahedron split level times, by no code of the kernel: 20 * 4^level triangles.
SurfaceMesh unitIcosphere(int level);

/// An icosphere stretched along the axes.
SurfaceMesh ellipsoid(int level, const Vec3& halfAxes);

/// An icosphere with bumps, without any symmetry.
SurfaceMesh bumpySphere(int level);

/**
 * The start of figure 6.2: the vertices of a unit sphere crowd at one side and lie unevenly
 * everywhere.
 */
SurfaceMesh unevenSphere(int level);

/// A unit sphere whose vertices, all on it, have moved by up to a fraction of the edge length.
SurfaceMesh shakenSphere(int level, double fraction, unsigned seed);

/// A sphere without its cap above a height (of radius 1): open.
SurfaceMesh bowl(int level, double height);

/// The upper half of the unit sphere, its boundary at z = 0.
SurfaceMesh halfSphere(Index rings);

} // namespace evolving::shapes

#endif
