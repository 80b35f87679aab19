// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Surfaces that run through themselves.
 */

#ifndef EVOLVING_TESTING_FOLDED_SHAPES_H
#define EVOLVING_TESTING_FOLDED_SHAPES_H

#include "Mesh/SurfaceMesh.h"

namespace evolving::shapes
{

/// Two cones over a polygon that goes twice round a star of five tips, each from its apex; the
/// corners at heights up to `unevenness`, so that no two edges meet.
SurfaceMesh starCones(double unevenness);

/// Random triangles that have their first corner in common.
SurfaceMesh umbrella(int count, unsigned seed);

/// Two boxes of one part, [-1, 1]^3 and [0, 2.2]^3: a tube leads round them from a triangle of one
/// to one of the other. Edges of the second run through diagonals of the first, which cannot be
/// cut.
SurfaceMesh boxesOfOnePart();

} // namespace evolving::shapes

#endif
