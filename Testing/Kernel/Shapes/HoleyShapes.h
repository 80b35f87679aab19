// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Surfaces with holes.
 */

#ifndef EVOLVING_TESTING_HOLEY_SHAPES_H
#define EVOLVING_TESTING_HOLEY_SHAPES_H

#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving::shapes
{

/// A unit sphere without what lies within an angle of the given directions.
SurfaceMesh drilledSphere(const std::vector<Vec3>& directions, double angle, int level = 4);

/// A square sheet of 2 n^2 triangles and side 1 in the plane z = 0, without a square in its middle.
SurfaceMesh sheetWithHole(Index n, double holeSide);

} // namespace evolving::shapes

#endif
