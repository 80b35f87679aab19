// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What makes good elements of a surface on its target, step by step.
 */

#ifndef EVOLVING_FINISH_STEPS_H
#define EVOLVING_FINISH_STEPS_H

#include "Execution.h"
#include "FeatureCapture/FeatureRelease.h"
#include "Mesh/SurfaceMesh.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/ReferenceSurface.h"
#include "ShrinkWrap/WrapTarget.h"
#include "ShrinkWrap/WrapTuning.h"

#include <functional>
#include <vector>

namespace evolving
{

class FinishSteps
{
public:
  /// These must outlive the steps.
  FinishSteps(
    const ReferenceSurface& reference, const WrapTarget& target, const Execution& execution)
    : Reference(reference)
    , Target(target)
    , Tuning(target.tuning.finish)
    , Size(target.elementSize())
    , Run(execution)
  {
  }

  /// Stops and follows the steps.
  const Execution& execution() const { return this->Run; }

  /// All vertices onto the reference.
  void land(EditableSurface& surface) const;
  /// In valleys another place of the target is nearer than the one that a vertex has left.
  void landOften(EditableSurface& surface) const;
  /// At rims of walls, rounder than elements can be, the fit lifts vertices off: back they go.
  void settle(EditableSurface& surface, const std::function<bool(const Vec3&)>& isAtWall) const;
  /// Ridges that lie on no crease become no saw teeth; then elements recover.
  void fairRidges(EditableSurface& surface) const;
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
  /**
   * Gives elements better angles where creases cost them more than they are worth, round by round:
   * first by remeshing, as some are cramped by a fold that has been smoothed; then the weakest
   * crease of each place is let go; after FinishTuning::releaseRounds all that are there.
   * @param inertia as fitAlong()
   */
  void easeCreases(
    EditableSurface& surface, const CreaseWorth& worth, int round, double inertia) const;
  /// A fit along the normals; only moves vertices.
  void fitUpright(EditableSurface& surface) const;
  /// Bad elements are replaced by others.
  void repair(EditableSurface& surface) const;
  /// Are there triangles with angles that no result should have?
  bool hasSlivers(const EditableSurface& surface) const;
  /// Remeshes around them, and locks all else: they are left where a stage had to be undone.
  void mend(EditableSurface& surface) const;
  /**
   * Faces reach for peaks and valleys that a fit gives up; only moves vertices.
   * @param target triangles
   * @param leastAngle of all elements in the end, in degrees
   */
  void reachPeaks(EditableSurface& surface, const SurfaceMesh& target, double leastAngle) const;
  /// Tips of the target, farther away than other peaks: capture finds those near vertices only.
  void reachTips(EditableSurface& surface, const std::vector<Vec3>& tips) const;

private:
  /// Remeshes and fits what is around some vertices, and locks all else.
  void recover(EditableSurface& surface, const std::vector<Index>& vertices, double inertia) const;
  std::vector<Index> slivers(const EditableSurface& surface) const;
  void lockFarFrom(EditableSurface& surface, const SurfaceMesh& faces) const;

  const ReferenceSurface& Reference;
  const WrapTarget& Target;
  const FinishTuning& Tuning;
  double Size; ///< of elements that nothing asks to be smaller
  const Execution& Run;
};

} // namespace evolving

#endif
