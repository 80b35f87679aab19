// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A function's values on a grid.
 */

#ifndef EVOLVING_TESTING_SAMPLED_ON_GRID_H
#define EVOLVING_TESTING_SAMPLED_ON_GRID_H

#include "Distance/DistanceGrid.h"

#include <vector>

namespace evolving
{

/// x fastest, as images have them.
template <typename Function>
std::vector<float> sampled(const DistanceGrid& grid, const Function& function)
{
  std::vector<float> values;
  const Extent& e = grid.extent;
  for (int k = e[4]; k <= e[5]; ++k)
  {
    for (int j = e[2]; j <= e[3]; ++j)
    {
      for (int i = e[0]; i <= e[1]; ++i)
      {
        const Vec3 point = grid.origin + Vec3(i, j, k).cwiseProduct(grid.spacing);
        values.push_back(static_cast<float>(function(point)));
      }
    }
  }
  return values;
}

} // namespace evolving

#endif
