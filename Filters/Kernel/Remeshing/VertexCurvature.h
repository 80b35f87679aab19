// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How much a surface is curved at its vertices, as elements see it.
 */

#ifndef EVOLVING_VERTEX_CURVATURE_H
#define EVOLVING_VERTEX_CURVATURE_H

#include "Remeshing/EditableSurface.h"

#include <vector>

namespace evolving
{

/**
 * Of each vertex the largest curvature of an edge at it, 1/length, seen from the normals at both
 * ends and averaged over its neighbours. Folds at creases, EditableSurface::curve(), are none.
 * @return one per vertex slot
 */
std::vector<double> vertexCurvatures(const EditableSurface& surface);

} // namespace evolving

#endif
