// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How long mean curvature flow takes: until a surface has vanished, until its shape is another.
 */

#ifndef EVOLVING_CURVATURE_LIFE_H
#define EVOLVING_CURVATURE_LIFE_H

#include "Mesh/SurfaceMesh.h"

namespace evolving
{

// All times are those of d_t F = Laplace F, epsilon = 1, and of closed surfaces unless said.

/**
 * A / (16 pi): the time that no surface outlives, for dA/dt = -(integral of H^2), and that integral
 * is at least 16 pi (Willmore), with equality for spheres: r^2 / 4.
 */
double longestLife(double area);

/**
 * 3/2 V / (integral of H), as dV/dt is that integral: the life of a sphere; of a long tube or a
 * thin ring, which live for V / (integral of H), half as much again. Noise and creases, which
 * vanish at once, hardly change that integral. Never more than longestLife(), which is what remains
 * where the integral is below 0, as on a sponge, whose holes are more than its outside.
 * @param curvature the integral of H
 */
double expectedLife(double area, double volume, double curvature);

/**
 * The time after which a surface has changed visibly, but enough is left to be seen. It grows with
 * the square of lengths. Of several components the one that takes longest counts.
 *
 * - Closed: half of expectedLife().
 * - With a boundary of length P: (1/4) min(A, P^2 / (4 pi)), for what differs from a minimal
 * surface, which has at most that area, has faded to a hundredth by then (on a disc the slowest
 * mode fades by exp(-5.78 t / R^2)); and half of longestLife(), for all the rest of the surface.
 *
 * @throws InputError as MeshTopology
 */
double timeOfVisibleChange(const SurfaceMesh& surface);

} // namespace evolving

#endif
