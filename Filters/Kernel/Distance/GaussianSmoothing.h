// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A Gaussian filter on a grid.
 */

#ifndef EVOLVING_GAUSSIAN_SMOOTHING_H
#define EVOLVING_GAUSSIAN_SMOOTHING_H

#include "Execution.h"
#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/// How many samples away from a sample its smoothed value still depends on the others: 3 sigma.
int smoothingRadius(double sigma);

/**
 * Convolves values with a Gaussian cut off at 3 sigma, axis by axis. At the ends of the grid
 * values continue point-symmetrically, so that linear functions stay what they are.
 * @param values x fastest; replaced
 * @param sigma in samples, the same along every axis; 0 does nothing
 * @throws Cancelled
 */
void smoothGaussian(std::vector<float>& values, const std::array<int, 3>& dimensions, double sigma,
  const Execution& execution = {});

} // namespace evolving

#endif
