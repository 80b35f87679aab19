// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Creases that run too close to others.
 */

#ifndef EVOLVING_CLOSE_CURVES_H
#define EVOLVING_CLOSE_CURVES_H

#include "Features/SharpEdges.h"
#include "Features/TargetTriangles.h"

namespace evolving
{

/**
 * Rule 3 of keepCarriable(): leaves out curves of which more than half runs within a distance of
 * other curves that border a common patch, the weakest first. Within three distances of a corner
 * that both curves share, they may be close.
 * @return whether an edge was left out
 */
bool dropCloseCurves(const TargetTriangles& target, SharpEdges& sharp, double distance);

} // namespace evolving

#endif
