// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Triangles, not vertices, come as close to the target as they can.
 */

#ifndef EVOLVING_SURFACE_FIT_H
#define EVOLVING_SURFACE_FIT_H

#include "Execution.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/ReferenceSurface.h"

#include <array>

namespace evolving
{

/// How the inner vertices of a surface may move in a fit.
struct FitOptions
{
  int iterations = 1;
  double damping = 1.0; ///< fraction of the way
  /**
   * What a move along the surface costs beside the squared distance it saves; infinite: vertices
   * move along their normals only. Along the surface vertices find the ridges of the target.
   */
  double tangentialInertia = 0.0;
};

/**
 * Moves the inner vertices so that the squared distance of the triangles from the reference is
 * least: a linear least-squares problem, the distances at fixed places of every triangle being
 * measured to the tangent plane at the closest point (Gauss-Newton). Vertices that lie on a curved
 * surface leave every triangle on its inner side; this takes the mean error away.
 * Vertices of curves, the boundary, corners and pinned ones stay. No face turns over.
 */
void fitToReference(EditableSurface& surface, const ReferenceSurface& reference,
  const FitOptions& options, const Execution& execution = {});

/// Barycentric coordinates of the places of a triangle where its distance is measured.
constexpr std::array<std::array<double, 3>, 6> FitPlaces = { {
  { 2.0 / 3.0, 1.0 / 6.0, 1.0 / 6.0 },
  { 1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0 },
  { 1.0 / 6.0, 1.0 / 6.0, 2.0 / 3.0 },
  { 0.1, 0.45, 0.45 },
  { 0.45, 0.1, 0.45 },
  { 0.45, 0.45, 0.1 },
} };

} // namespace evolving

#endif
