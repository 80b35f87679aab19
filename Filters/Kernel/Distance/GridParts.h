// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Parts of a grid: widened, and their values cut out of those of the whole.
 */

#ifndef EVOLVING_GRID_PARTS_H
#define EVOLVING_GRID_PARTS_H

#include "Distance/DistanceGrid.h"
#include "Types.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace evolving
{

/// The part widened by a margin, inside the whole.
inline Extent grown(const Extent& part, int margin, const Extent& whole)
{
  Extent extent = part;
  for (std::size_t e = 0; e < 6; e += 2)
  {
    extent[e] = std::max(part[e] - margin, whole[e]);
    extent[e + 1] = std::min(part[e + 1] + margin, whole[e + 1]);
  }
  return extent;
}

/// Of values at all samples of a grid, so many numbers each, those of a part of it.
template <typename Value>
std::vector<Value> cut(
  std::vector<Value> values, GridIndex components, const DistanceGrid& grid, const Extent& part)
{
  if (part == grid.extent)
  {
    return values;
  }
  const GridIndex width = components * (part[1] - part[0] + 1);
  std::vector<Value> result;
  result.reserve(static_cast<std::size_t>(components * grid.part(part).sampleCount()));
  for (int k = part[4]; k <= part[5]; ++k)
  {
    for (int j = part[2]; j <= part[3]; ++j)
    {
      const auto first = values.begin() + components * grid.index(part[0], j, k);
      result.insert(result.end(), first, first + width);
    }
  }
  return result;
}

} // namespace evolving

#endif
