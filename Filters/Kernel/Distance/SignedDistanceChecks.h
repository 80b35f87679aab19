// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What signedDistance() asks of its options and its grid.
 */

#ifndef EVOLVING_SIGNED_DISTANCE_CHECKS_H
#define EVOLVING_SIGNED_DISTANCE_CHECKS_H

#include "Distance/DistanceGrid.h"
#include "Distance/SignedDistanceOptions.h"

namespace evolving
{

/// @throws InputError when a number is out of its range or not finite
void requireUsable(const SignedDistanceOptions& options);

/// @throws InputError when the grid is empty or not finite, or the part is not inside it
void requireUsable(const DistanceGrid& grid, const Extent& part);

} // namespace evolving

#endif
