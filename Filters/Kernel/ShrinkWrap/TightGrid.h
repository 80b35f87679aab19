// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A distance grid no larger than the model needs.
 */

#ifndef EVOLVING_TIGHT_GRID_H
#define EVOLVING_TIGHT_GRID_H

#include "Distance/DistanceGrid.h"
#include "Types.h"

#include <array>

namespace evolving
{

/**
 * Cubic cells, as small as all dimensions allow, and along each axis only as many of them as the
 * box and the room around it need. Three more cells on every side.
 * @param room around the box, a length
 */
DistanceGrid tightGrid(const Box& box, const std::array<int, 3>& dimensions, double room);

/// The room for which tightGrid() has cells of a size; negative where its cells are larger anyway.
double roomForCells(const Box& box, const std::array<int, 3>& dimensions, double cell);

/// The samples along an axis for which tightGrid() has cells no larger than a size, on every axis.
int samplesForCells(const Box& box, double room, double cell);

} // namespace evolving

#endif
