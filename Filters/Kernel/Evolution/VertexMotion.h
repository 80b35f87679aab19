// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The vertices of a surface with given elements on their way: velocities at the current state, and
 * the motion by them.
 */

#ifndef EVOLVING_VERTEX_MOTION_H
#define EVOLVING_VERTEX_MOTION_H

#include "Evolution/ControlFunctions.h"
#include "Evolution/FlowOptions.h"
#include "Evolution/SemiImplicitStep.h"
#include "Execution.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceMesh.h"
#include "Operators/SurfaceGeometry.h"
#include "Redistribution/InversionLimiter.h"
#include "Redistribution/StateArrays.h"
#include "Redistribution/SurfaceCurves.h"
#include "Redistribution/TangentialVelocity.h"
#include "Redistribution/VanishedComponents.h"

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
class VertexMotion
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
  VertexMotion(SurfaceMesh start, const ControlField& field, const FlowOptions& options,
    double size, double timeStep, double smallestComponent, const Execution& execution);
  VertexMotion(const VertexMotion&) = delete;
  VertexMotion& operator=(const VertexMotion&) = delete;

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
  StateArrays arrays() const;
  const SurfaceGeometry& geometry() const { return this->Geometry; }
  /// Of the last evaluation and of the last advance().
  int evaluationIterations() const { return this->Tangential.iterations(); }
  int advanceIterations() const { return this->Step.iterations(); }

private:
  /// Where a step begins and ends.
  struct Move
  {
    SurfacePosition before;
    std::vector<char> isHeld; ///< vertices that only slide
    LimitedMove limited;
    double timeStep = 0.0;
  };

  void limitAdvection(const Execution& execution);
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
  InversionLimiter Limiter;
  SurfaceGeometry Geometry;
  const ControlField& Field;
  TangentialVelocity Tangential;
  SemiImplicitStep Step;
  ControlValues Controls;
  std::vector<Vec3> NormalVelocity;  ///< v_N
  std::vector<Vec3> TangentVelocity; ///< v_T
  Move LastMove;
};

} // namespace evolving

#endif
