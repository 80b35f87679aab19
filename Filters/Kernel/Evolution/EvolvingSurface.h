// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A surface that moves step by step and may get new elements between the steps.
 */

#ifndef EVOLVING_EVOLVING_SURFACE_H
#define EVOLVING_EVOLVING_SURFACE_H

#include "Evolution/ControlFunctions.h"
#include "Evolution/FlowSetup.h"
#include "Evolution/Remesher.h"
#include "Evolution/StartTrace.h"
#include "Evolution/SurfaceGuard.h"
#include "Evolution/VertexMotion.h"
#include "Execution.h"

#include <memory>
#include <vector>

namespace evolving
{

/// Where a surface is, and with which elements.
struct SurfacePlace
{
  std::shared_ptr<const SurfaceMesh> origin; ///< see FlowState::origin
  SurfacePosition position;
  std::shared_ptr<const std::vector<Vec3>> startPoints; ///< see FlowState::startPoints
};

/**
 * Owns the motion of the current elements, and replaces it when they change: reference normals,
 * boundary curves and components are those of the new surface, and the solvers start afresh.
 * What belongs to the flow stays: the field, the guard's box and the smallest area that counts.
 */
class EvolvingSurface
{
public:
  /**
   * @param field may be null
   * @param remesher may be null: the elements stay
   * @throws InputError
   */
  EvolvingSurface(std::shared_ptr<const SurfaceMesh> start,
    std::shared_ptr<const ScalarImage> field, std::shared_ptr<Remesher> remesher,
    const FlowSetup& setup, const Execution& execution);

  const SurfaceMesh& mesh() const { return this->Motion->mesh(); }
  /// Of the last evaluation.
  StateArrays arrays() const { return this->Motion->arrays(); }
  /// The area of its elements with other points.
  double areaAt(const std::vector<Vec3>& points, const Execution& execution) const;

  SurfacePlace place() const
  {
    return { this->Origin, this->Motion->position(), this->StartPoints };
  }
  void setPlace(const SurfacePlace& place, const Execution& execution);

  /// Computes the velocities of the step after an iteration. @throws SolverError, Cancelled
  void evaluate(int iteration, const Execution& execution);
  /// One time step, in equal parts. @throws SolverError, Cancelled
  void move(int iteration, int parts, const Execution& execution);
  /**
   * Asks the remesher, if there is one, for new elements.
   * @param isLast the flow ends here
   * @return whether it gave any
   * @throws SolverError when they make no surface that can be evolved
   * @throws what the remesher throws
   */
  bool remesh(bool isLast, const Execution& execution);

  /// As ControlField::edgeSharpness().
  double edgeSharpness() const { return this->Field->edgeSharpness(); }
  /// As SurfacePosition has it.
  bool isRedistributed() const { return this->Motion->isRedistributed(); }
  /// Since the last reset.
  int solverIterations() const { return this->SolverIterations; }
  void resetSolverIterations() { this->SolverIterations = 0; }

private:
  std::shared_ptr<const std::vector<Vec3>> traceStart(
    const SurfaceMesh& remeshed, const Execution& execution) const;
  void setElements(std::shared_ptr<const SurfaceMesh> origin, const Execution& execution);

  FlowSetup Setup;
  SurfaceGuard Guard;
  std::unique_ptr<const ControlField> Field; ///< at one place: the motion refers to it
  std::shared_ptr<Remesher> NewElements;
  std::shared_ptr<const SurfaceMesh> Origin;
  std::unique_ptr<const StartTrace> Trace; ///< null when the start is not traced
  std::shared_ptr<const std::vector<Vec3>> StartPoints;
  double SmallestComponent = 0.0; ///< area of one at the start
  std::unique_ptr<VertexMotion> Motion;
  bool HasVelocities = false; ///< the motion's are those of its position
  int SolverIterations = 0;
};

} // namespace evolving

#endif
