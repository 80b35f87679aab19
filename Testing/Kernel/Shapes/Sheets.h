// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Open surfaces that lie in a plane, or above one.
 */

#ifndef EVOLVING_TESTING_SHEETS_H
#define EVOLVING_TESTING_SHEETS_H

#include "Mesh/SurfaceMesh.h"

#include <cmath>

namespace evolving::shapes
{

/// n x n squares over [0, 1]^2, as quads or each cut into two triangles; (n + 1)^2 vertices.
SurfaceMesh sheet(Index n, bool triangles);

/// rows by columns points (i, j, 0), each square cut into two triangles.
SurfaceMesh triangleSheet(Index rows, Index columns);

/// The inner vertices of sheet() moved within the plane by up to `amount` cells.
SurfaceMesh shakenSheet(Index n, bool triangles, double amount, unsigned seed);

/// The triangles of a height over the square [-1, 1]^2, with count squares a side.
template <typename Height>
SurfaceMesh heightField(Index count, const Height& height)
{
  SurfaceMesh mesh = sheet(count, true);
  for (Vec3& p : mesh.points)
  {
    const double x = -1.0 + 2.0 * p.x();
    const double y = -1.0 + 2.0 * p.y();
    p = Vec3(x, y, height(x, y));
  }
  return mesh;
}

/// The unit disc at z = 0 in rings of triangles; vertex 0 at the centre, 6 * rings on the boundary.
SurfaceMesh disc(Index rings);

/// The unit disc as count triangles around vertex 0.
SurfaceMesh fan(Index count);

/// A flat ring of quads between radius 1 and 2, two loops of count vertices.
SurfaceMesh annulus(Index count);

} // namespace evolving::shapes

#endif
