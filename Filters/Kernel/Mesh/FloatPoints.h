// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What single precision makes of a surface: far from the origin the numbers that it has lie farther
 * apart than the corners of small elements.
 */

#ifndef EVOLVING_FLOAT_POINTS_H
#define EVOLVING_FLOAT_POINTS_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// The points as floats have them.
std::vector<Vec3> roundedToFloats(std::vector<Vec3> points);

/**
 * Do the elements keep their shapes when the points become floats? An edge of length e whose ends
 * move by different vectors, apart by c, turns by at most c / e, and an angle between two edges by
 * the sum of both. That must stay below one degree on the average over the edges, weighted by
 * length, so that elements that have lost their size anyway do not decide.
 */
bool floatsHold(const SurfaceMesh& mesh);

} // namespace evolving

#endif
