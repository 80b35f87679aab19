// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Long triangles cut across, for sums in which a group of triangles counts as one when it is small
 * beside its distance.
 */

#ifndef EVOLVING_CUT_SLIVERS_H
#define EVOLVING_CUT_SLIVERS_H

#include "Trees/TriangleGeometry.h"

#include <vector>

namespace evolving
{

/**
 * The same surface with every triangle far longer than high cut into shorter ones, at the middles
 * of longest edges. A thousand slivers side by side are as long as one of them, and a point among
 * them is near to all; of their pieces it is near to few. Other triangles stay as they are.
 * As short as several times the number of triangles allows.
 */
std::vector<Triangle> withSliversCut(const std::vector<Triangle>& triangles);

} // namespace evolving

#endif
