// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What makes good elements of a surface on its target, step by step: all of it with the settings
 * that measurements on many models have led to.
 */

#ifndef EVOLVING_FINISH_STEPS_H
#define EVOLVING_FINISH_STEPS_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/ReferenceSurface.h"

namespace evolving
{

/// Passes of remeshOnce().
void remeshOften(EditableSurface& surface, const ReferenceSurface& reference, int passes,
  const Execution& execution);

/// Sizes follow the curvature, with as many vertices as of one size.
void remeshByCurvature(EditableSurface& surface, const ReferenceSurface& reference, double size,
  const Execution& execution);

void polish(
  EditableSurface& surface, const ReferenceSurface& reference, const Execution& execution);

/// The stars of the worst elements.
void improve(
  EditableSurface& surface, const ReferenceSurface& reference, const Execution& execution);

/**
 * A fit in which vertices also move along the surface, to find its ridges; then elements recover.
 * @param inertia FitOptions::tangentialInertia
 */
void fitAlong(EditableSurface& surface, const ReferenceSurface& reference, double inertia,
  const Execution& execution);

/// A fit along the normals; only moves vertices.
void fitUpright(
  EditableSurface& surface, const ReferenceSurface& reference, const Execution& execution);

/// Bad elements are replaced by others.
void repair(
  EditableSurface& surface, const ReferenceSurface& reference, const Execution& execution);

/**
 * Faces reach for peaks and valleys that a fit gives up; only moves vertices.
 * @param target its triangles; @param size of elements, if they were of one
 * @param leastAngle of all elements in the end, in degrees
 */
void reachPeaks(EditableSurface& surface, const ReferenceSurface& reference,
  const SurfaceMesh& target, double size, double leastAngle, const Execution& execution);

} // namespace evolving

#endif
