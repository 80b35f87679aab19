// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The direction in which a distance grows.
 */

#ifndef EVOLVING_DISTANCE_GRADIENT_H
#define EVOLVING_DISTANCE_GRADIENT_H

#include "Distance/DistanceGrid.h"
#include "Execution.h"

#include <vector>

namespace evolving
{

/**
 * Central differences, one-sided at the ends of the grid, zero along axes of one sample; of unit
 * length, or zero where the differences vanish.
 * @param values one per sample
 * @return three per sample
 * @throws Cancelled
 */
std::vector<float> normalizedDifferences(
  const DistanceGrid& grid, const std::vector<float>& values, const Execution& execution = {});

} // namespace evolving

#endif
