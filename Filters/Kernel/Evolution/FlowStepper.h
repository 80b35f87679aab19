// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A surface on its way: its velocities at the current state, and the motion by them.
 */

#ifndef EVOLVING_FLOW_STEPPER_H
#define EVOLVING_FLOW_STEPPER_H

#include "Evolution/ControlFunctions.h"
#include "Evolution/EvolutionStep.h"
#include "Evolution/FlowOptions.h"
#include "Evolution/StepLimiter.h"
#include "Evolution/SurfaceCurves.h"
#include "Evolution/SurfaceFlow.h"
#include "Evolution/SurfaceGeometry.h"
#include "Evolution/TangentialVelocity.h"
#include "Evolution/VanishedComponents.h"
#include "Execution.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving
{

/// Where a surface with given faces is.
struct SurfacePosition
{
  std::vector<Vec3> points;
  SurfaceCurves::Positions onCurves; ///< of boundary vertices that slide
};

/**
 * Evaluates (4.1) and advances by (4.16), without knowing of steps, retries or ends.
 * Not movable: its parts refer to each other.
 */
class FlowStepper
{
public:
  /**
   * @param field must outlive this object
   * @param options in absolute units
   * @param size a length: L
   * @param timeStep the length of advance() that velocities are limited for
   * @param smallestComponent see VanishedComponents
   * @throws InputError
   */
  FlowStepper(SurfaceMesh start, const ControlField& field, const FlowOptions& options, double size,
    double timeStep, double smallestComponent, const Execution& execution);
  FlowStepper(const FlowStepper&) = delete;
  FlowStepper& operator=(const FlowStepper&) = delete;

  const SurfaceMesh& mesh() const { return this->Mesh; }
  /// The area of the smallest component at the start.
  double smallestComponentArea() const { return this->Vanished.smallestStartArea(); }
  SurfacePosition position() const { return { this->Mesh.points, this->OnCurves }; }
  void setPosition(const SurfacePosition& position);

  /// Computes the velocities of the normal evolution. @throws SolverError, Cancelled
  void evaluateFlow(const Execution& execution);
  /// Computes the velocities of a smoothing step. @throws SolverError, Cancelled
  void evaluateSmoothing(double epsilon, const Execution& execution);

  /// Moves the points; the velocities are those of before until the next evaluation.
  /// @throws SolverError, Cancelled
  void advance(double timeStep, const Execution& execution);
  /**
   * Changes the last move of single vertices so that no face turns over.
   * @param before the points that faces are compared with, those of the last move's start or of
   * a limited one before it
   * @throws SolverError when many turn over
   */
  void limitLastMove(const std::vector<Vec3>& before, const Execution& execution);

  /// Of the last evaluation.
  FlowArrays arrays() const;
  const SurfaceGeometry& geometry() const { return this->Geometry; }
  /// Of the last evaluation and of the last advance().
  int evaluationIterations() const { return this->Tangential.iterations(); }
  int advanceIterations() const { return this->Step.iterations(); }

private:
  /// A step from where to where.
  struct Move
  {
    SurfacePosition before;
    std::vector<char> isHeld; ///< vertices that only slide
    LimitedMove limited;
    double timeStep = 0.0;
  };

  void evaluateVelocities(const Execution& execution);
  void redoLastMove(const Execution& execution);
  std::vector<Vec3> slide(const std::vector<Vec3>& velocity, double timeStep);
  bool isHeld(Index vertex) const;

  SurfaceMesh Mesh;
  FlowOptions Options;
  double Size;
  double TimeStep;
  MeshTopology Topology;
  SurfaceCurves Curves;
  SurfaceCurves::Positions OnCurves;
  VanishedComponents Vanished;
  StepLimiter Limiter;
  SurfaceGeometry Geometry;
  const ControlField& Field;
  TangentialVelocity Tangential;
  EvolutionStep Step;
  ControlValues Controls;
  std::vector<Vec3> NormalVelocity;  ///< v_N
  std::vector<Vec3> TangentVelocity; ///< v_T
  Move LastMove;
};

} // namespace evolving

#endif
