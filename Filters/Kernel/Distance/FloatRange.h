// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Distances are floats: which meshes and grids have distances that a float can hold.
 */

#ifndef EVOLVING_FLOAT_RANGE_H
#define EVOLVING_FLOAT_RANGE_H

#include "Distance/DistanceGrid.h"
#include "Types.h"

namespace evolving
{

/// @throws InputError when a mesh of this box is larger than 1e31 or smaller than 1e-31
void requireSizeForFloats(const Box& mesh);

/// @throws InputError when the grid's distances to the mesh are too large or its cells too small
void requireDistancesForFloats(const Box& mesh, const DistanceGrid& grid);

} // namespace evolving

#endif
