// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The surface of least area through a closed polygon in space, as triangles.
 */

#ifndef EVOLVING_LEAST_AREA_CAP_H
#define EVOLVING_LEAST_AREA_CAP_H

#include "Types.h"

#include <array>
#include <functional>
#include <vector>

namespace evolving
{

/// Asked whether a cap may have an edge between two corners that are not neighbours; the smaller
/// number comes first.
using DiagonalPredicate = std::function<bool(Index, Index)>;

/**
 * The triangulation of a closed polygon in space with the least area, by dynamic programming
 * (Barequet, Sharir 1995). Slivers count as a little more than their area, a tenth more at a
 * quality of 1/10, so that corners on a line give no triangle without area. Simple for every simple
 * planar polygon. Takes n^3 / 6 evaluations and 12 n^2 bytes.
 * @return numbers of the polygon's corners, three per triangle in rising order; none when there is
 * no triangulation with allowed diagonals
 */
std::vector<std::array<Index, 3>> leastAreaCap(
  const std::vector<Vec3>& corners, const DiagonalPredicate& isAllowed);

} // namespace evolving

#endif
