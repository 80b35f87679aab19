// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The iso-surface start: a closed 2-manifold around the samples below a value.
 *
 * Naive surface nets (Gibson 1998): one vertex in every cell that the surface passes, one quad
 * for every grid edge that it crosses. Manifoldness is not hoped for but made: the samples are
 * well-composed first (WellComposed.h), so that the surface passes every cell at most once and
 * crosses every cell face in at most one line.
 */

#ifndef EVOLVING_ISOSURFACE_H
#define EVOLVING_ISOSURFACE_H

#include "Distance/DistanceGrid.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving
{

struct IsosurfaceOptions
{
  double isoValue = 0.0;     ///< samples below it are inside
  bool fillCavities = false; ///< keep only surfaces that can be reached from the grid's border
  /// Vertices move to their neighbours' mean, each within its cell. One sweep removes the worst
  /// angles and costs about 0.05 of a cell in accuracy; more smooth away detail.
  int relaxationSweeps = 0;
  bool triangles = true; ///< split the quads (QuadSplitting.h)
};

/**
 * The surface between the samples below the iso-value and the others; beyond the grid's border
 * all is outside, so a region that touches the border gets a wall there.
 * The result is closed, 2-manifold and oriented outwards, for any field. It is empty when no
 * sample is below the iso-value. Without relaxation vertices are the means of the points where
 * the linearly interpolated field crosses the cell's edges: an error of second order in the
 * spacing for a smooth field.
 * @param field one finite value per sample of the grid, x fastest
 * @throws InputError when the field does not fit the grid, a value is not finite, the spacing is
 * not positive or an option is out of range
 * @throws Cancelled
 */
SurfaceMesh isosurface(const DistanceGrid& grid, const std::vector<float>& field,
  const IsosurfaceOptions& options, const Execution& execution = {});

} // namespace evolving

#endif
