// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The eikonal equation |grad d| = 1 on a grid of cubes by Gauss-Seidel sweeps in alternating
 * directions (section 5.3 of the thesis; Zhao, A Fast Sweeping Method for Eikonal Equations,
 * 2004).
 */

#ifndef EVOLVING_FAST_SWEEPING_H
#define EVOLVING_FAST_SWEEPING_H

#include "Execution.h"
#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/// A field to be swept, in units of the grid's spacing; x runs fastest.
struct SweptField
{
  std::array<int, 3> dimensions{ 0, 0, 0 };
  std::vector<float> distance;
  std::vector<char> frozen; ///< not 0 where the distance is given

  /// Nothing frozen, every distance above any possible one.
  explicit SweptField(const std::array<int, 3>& gridDimensions);
  GridIndex index(int i, int j, int k) const;
  void freeze(GridIndex sample, float value);
};

/**
 * The solution x of sum_p ((x - a_p)^+)^2 = 1 for a_1 <= a_2 <= a_3: with the fewest terms p
 * for which x <= a_{p+1} (Godunov's upwind differences).
 */
float godunovSolution(float a1, float a2, float a3);

/**
 * Sweeps the field in the order +++, -++, --+, ---, -+-, ++-, +--, +-+ (x, y, z), again from
 * the first after the eighth. First order in the spacing; eight sweeps reach every sample.
 * @throws Cancelled
 */
void sweep(SweptField& field, int numberOfSweeps, const Execution& execution = {});

} // namespace evolving

#endif
