// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How long flows take that end in balls.
 */

#ifndef EVOLVING_RELAXATION_TIME_H
#define EVOLVING_RELAXATION_TIME_H

#include "Mesh/SurfaceMesh.h"

namespace evolving
{

/**
 * The time after which a thousandth is left of what differs from a ball, in flows that hold the
 * volume. On a ball of radius r a mode of degree l fades by exp(-s t), slowest for l = 2:
 *
 * - volume-preserving mean curvature flow: s = (l - 1)(l + 2) / r^2 = 4 / r^2;
 * - surface diffusion: s = (l - 1) l (l + 1)(l + 2) / r^4 = 24 / r^4.
 *
 * r is that of the ball with as much area, which grows with what a surface is long. Of several
 * components the largest counts. Speeds are 1.
 *
 * @throws InputError as MeshTopology
 */
double relaxationTimeOfCurvatureFlow(const SurfaceMesh& surface);
double relaxationTimeOfDiffusion(const SurfaceMesh& surface);

} // namespace evolving

#endif
