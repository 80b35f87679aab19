// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Co-volumes to aim at: equal, or smaller where the surface is curved (3.21), (3.22).
 */

#ifndef EVOLVING_CURVATURE_DENSITY_H
#define EVOLVING_CURVATURE_DENSITY_H

#include "Execution.h"
#include "Operators/SurfaceGeometry.h"
#include "Redistribution/RedistributionOptions.h"

#include <vector>

namespace evolving
{

/// The largest ratio of two wanted co-volumes in a component.
constexpr double LargestAreaRatio = 10.0;

/**
 * The wanted co-volume of every vertex, A (1 / f(H_i)) / sum_j (1 / f(H_j)) (4.26), per connected
 * component; A / n without curvature control. They sum to the component's area A.
 *
 * |H| is averaged once over each vertex and its neighbours. f is kept within a factor of
 * sqrt(10) above and below its median over the component (below its maximum by 10 where most
 * of the component is flat).
 * @param alpha of f = exp(alpha |H|), a length
 */
std::vector<double> wantedCoVolumes(const SurfaceGeometry& geometry, CurvatureControl control,
  double alpha, const Execution& execution);

} // namespace evolving

#endif
