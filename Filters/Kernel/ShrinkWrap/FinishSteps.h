// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What makes good elements of a surface on its target, step by step.
 */

#ifndef EVOLVING_FINISH_STEPS_H
#define EVOLVING_FINISH_STEPS_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/ReferenceSurface.h"
#include "ShrinkWrap/WrapTuning.h"

namespace evolving
{

class FinishSteps
{
public:
  /// @param size of elements, if they were of one; the others are kept, too
  FinishSteps(const ReferenceSurface& reference, const FinishTuning& tuning, double size,
    const Execution& execution)
    : Reference(reference)
    , Tuning(tuning)
    , Size(size)
    , Run(execution)
  {
  }

  /// Passes of remeshOnce().
  void remesh(EditableSurface& surface, int passes) const;
  /// Sizes follow the curvature, with as many vertices as of one size.
  void remeshByCurvature(EditableSurface& surface) const;
  void polish(EditableSurface& surface) const;
  /// The stars of the worst elements.
  void improve(EditableSurface& surface) const;
  /**
   * A fit in which vertices also move along the surface, to find its ridges; then elements recover.
   * @param inertia FitOptions::tangentialInertia
   */
  void fitAlong(EditableSurface& surface, double inertia) const;
  /// A fit along the normals; only moves vertices.
  void fitUpright(EditableSurface& surface) const;
  /// Bad elements are replaced by others.
  void repair(EditableSurface& surface) const;
  /**
   * Faces reach for peaks and valleys that a fit gives up; only moves vertices.
   * @param target triangles
   * @param leastAngle of all elements in the end, in degrees
   */
  void reachPeaks(EditableSurface& surface, const SurfaceMesh& target, double leastAngle) const;

private:
  const ReferenceSurface& Reference;
  const FinishTuning& Tuning;
  double Size;
  const Execution& Run;
};

} // namespace evolving

#endif
