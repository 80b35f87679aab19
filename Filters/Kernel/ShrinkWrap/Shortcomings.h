// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What is wrong with a finished surface, in words for the user.
 */

#ifndef EVOLVING_SHORTCOMINGS_H
#define EVOLVING_SHORTCOMINGS_H

#include "ShrinkWrap/SurfaceReport.h"

#include <string>
#include <vector>

namespace evolving
{

/**
 * How far a place may be from where it belongs before it counts as lost: two edges of the surface,
 * but no more than a fifteenth of the model, where edges are long.
 * @param modelSize the diagonal of its box; 0 = unknown
 */
double farDistance(double edgeLength, double modelSize);

/**
 * One sentence for everything that a surface fit for simulation should have and this one has not:
 * what, and where. Empty when all is well.
 * @param edgeLength of its triangles
 */
std::vector<std::string> shortcomings(const SurfaceReport& report, double edgeLength);

} // namespace evolving

#endif
