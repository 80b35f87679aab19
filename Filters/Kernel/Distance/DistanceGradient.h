// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The direction in which a distance grows.
 */

#ifndef EVOLVING_DISTANCE_GRADIENT_H
#define EVOLVING_DISTANCE_GRADIENT_H

#include "Distance/DistanceGrid.h"
#include "Distance/DistanceTarget.h"
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

/**
 * Unit vectors away from the closest points, turned round inside. On the surface, where there is
 * no such direction, its pseudonormal.
 * @param triangles the closest one of each sample
 * @param inside not 0 for samples inside
 * @param isSigned false for an unsigned distance, whose gradient on the surface is zero
 * @return three per sample
 * @throws Cancelled
 */
std::vector<float> awayFromClosest(const DistanceTarget& target, const DistanceGrid& grid,
  const std::vector<Index>& triangles, const std::vector<char>& inside, bool isSigned,
  const Execution& execution = {});

} // namespace evolving

#endif
