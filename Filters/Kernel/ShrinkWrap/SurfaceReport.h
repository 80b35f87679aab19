// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What can be said of a finished surface: its topology, its worst element, its distance to the
 * target. Measured, never assumed.
 */

#ifndef EVOLVING_SURFACE_REPORT_H
#define EVOLVING_SURFACE_REPORT_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"

namespace evolving
{

struct SurfaceReport
{
  bool isClosed = false;
  bool isManifold = false;     ///< one fan of faces at every vertex, consistently oriented
  Index selfIntersections = 0; ///< pairs of triangles
  Index genus = 0;             ///< of all components together; -1 when not closed or not manifold
  double minAngle = 0.0;       ///< degrees
  double maxDistance = 0.0;    ///< of a vertex from the surface at `level` around the target
};

/**
 * @param surface triangles
 * @param target triangles or points
 * @param level the distance from the target at which the surface is meant to lie
 * @throws Cancelled
 */
SurfaceReport examine(const SurfaceMesh& surface, const SurfaceMesh& target, double level,
  const Execution& execution = {});

} // namespace evolving

#endif
