// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Whether one surface encloses what another one winds around, point by point.
 */

#ifndef EVOLVING_TESTING_WINDING_COMPARISON_H
#define EVOLVING_TESTING_WINDING_COMPARISON_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

namespace evolving::checks
{

/// The sum over all triangles.
double windingAround(const SurfaceMesh& mesh, const Vec3& point);

struct WindingComparison
{
  int inside = 0;    ///< points that the mesh winds around, in any direction
  int different = 0; ///< points of these that the surface does not wind around once, or others that
                     ///< it winds around
};

/// At random points in the box of the mesh, over all triangles. Closed surfaces.
WindingComparison compareWinding(
  const SurfaceMesh& mesh, const SurfaceMesh& surface, int points, unsigned seed);

} // namespace evolving::checks

#endif
