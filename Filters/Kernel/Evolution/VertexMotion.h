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
#include "VolumeFlows/HeldVolumes.h"
#include "VolumeFlows/SurfaceDiffusion.h"

#include <optional>
#include <vector>

namespace evolving
{

/// Where a surface with given faces is.
struct SurfacePosition
{
  std::vector<Vec3> points;
  SurfaceCurves::Positions onCurves; ///< of boundary vertices that slide
  /// False from where no volume-based velocity was to be had, as at a neck that has pinched off.
  bool isRedistributed = true;
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
  /// Volumes of the components as they are held; empty where the flow holds none.
  std::vector<double> heldVolumes() const;
  /// The area of the smallest component at the start.
  double smallestComponentArea() const { return this->Vanished.smallestStartArea(); }
  SurfacePosition position() const
  {
    return { this->Mesh.points, this->OnCurves, this->IsRedistributed };
  }
  void setPosition(const SurfacePosition& position);
  bool isRedistributed() const { return this->IsRedistributed; }

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
  int evaluationIterations() const
  {
    return this->Tangential.iterations() + this->DiffusionIterations;
  }
  int advanceIterations() const { return this->Step.iterations(); }

private:
  /// Where a step begins and ends.
  struct Move
  {
    SurfacePosition before;
    std::vector<char> isHeld; ///< vertices that only slide
    LimitedMove limited;
    std::vector<Vec3> response; ///< what a multiplier of the volume adds to it
    double timeStep = 0.0;
  };

  void takeControls(const Execution& execution);
  void takeDiffusion(const Execution& execution);
  void evaluateVelocities(const Execution& execution);
  void evaluateTangential(const Execution& execution);
  void dropVolumeRedistribution();
  std::vector<Vec3> responseToVolume(const Execution& execution);
  void restoreVolumes(const Execution& execution);
  void redoLastMove(const Execution& execution);
  std::vector<Vec3> slide(const std::vector<Vec3>& velocity, double timeStep);
  bool isHeld(Index vertex) const;
  std::vector<char> heldVertices() const;

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
  bool IsRedistributed = true;
  SemiImplicitStep Step;
  SurfaceDiffusion Diffusion;
  int DiffusionIterations = 0;        ///< of the last evaluation
  std::optional<HeldVolumes> Volumes; ///< where the flow holds them
  ControlValues Controls;
  std::vector<Vec3> GivenVelocity;   ///< what (4.16) takes as it is: eta N, or all of diffusion
  std::vector<Vec3> NormalVelocity;  ///< v_N
  std::vector<Vec3> TangentVelocity; ///< v_T
  Move LastMove;
};

} // namespace evolving

#endif
