// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Points that stand for a whole surface.
 */

#ifndef EVOLVING_TARGET_SAMPLES_H
#define EVOLVING_TARGET_SAMPLES_H

#include "Mesh/SurfaceMesh.h"
#include "Trees/TriangleGeometry.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// Point i of a sequence that fills a triangle evenly; the first is its centroid.
Vec3 sampleOf(const Triangle& triangle, GridIndex i);

/**
 * All points, and points on them about `spacing` apart: one for every spacing^2
 * of the running sum of areas, spread by the R2 sequence where a triangle has several (Roberts,
 * *The Unreasonable Effectiveness of Quasirandom Sequences*, 2018).
 */
std::vector<Vec3> samplesOf(const SurfaceMesh& triangles, double spacing);

} // namespace evolving

#endif
