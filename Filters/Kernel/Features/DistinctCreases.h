// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Creases that were made, told from folds of a coarse or noisy surface.
 */

#ifndef EVOLVING_DISTINCT_CREASES_H
#define EVOLVING_DISTINCT_CREASES_H

#include "Features/SharpEdges.h"
#include "Features/TargetTriangles.h"

namespace evolving
{

/**
 * Leaves out all sharp edges of those connected parts of a surface whose folds are no creases. A
 * sharp edge stands out where it folds much more than the other edges of its faces, as between
 * faces of a machined part, flat or round; on scans and coarse models of animals those fold a good
 * deal, too. A part keeps its sharp edges when more than half of their length stands out.
 */
void keepDistinctCreases(const TargetTriangles& target, SharpEdges& sharp);

} // namespace evolving

#endif
