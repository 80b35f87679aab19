// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A closed surface amidst points: the target that a point set stands for.
 */

#ifndef EVOLVING_POINT_SURFACE_H
#define EVOLVING_POINT_SURFACE_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "ShrinkWrap/ShrinkWrapOptions.h"
#include "ShrinkWrap/WrapTuning.h"

namespace evolving
{

/**
 * Balls that stay outside of the points enclose a region; the smallest ones that cannot come in
 * between the points touch the surface that is meant (alpha shapes: Edelsbrunner, Muecke, 1994).
 * That surface is then fitted to the points by least squares (PointFit.h), which takes noise and
 * the bridges over concave parts away. Points that enclose nothing, as those of a sheet, get a thin
 * closed wall.
 * @param points in any order; one given twice counts once
 * @param options sampleDimensions, and gapSize: the balls' diameter, 0 = found as said
 * @return closed, 2-manifold, outwards, of triangles
 * @throws InputError for fewer than four different points, or points on a line: they bound nothing
 * @throws Cancelled
 */
SurfaceMesh surfaceAmidst(const SurfaceMesh& points, const ShrinkWrapOptions& options,
  const Execution& execution = {}, const PointTuning& tuning = {});

} // namespace evolving

#endif
