// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The evolution of a surface in time: d_t F = epsilon Laplace F + eta N + v_T (4.1), from the
 * start surface to the last smoothing step.
 */

#ifndef EVOLVING_SURFACE_FLOW_H
#define EVOLVING_SURFACE_FLOW_H

#include "Evolution/EvolvingSurface.h"
#include "Evolution/ExtinctionTest.h"
#include "Evolution/FlowOptions.h"
#include "Evolution/FlowSetup.h"
#include "Evolution/FlowState.h"
#include "Evolution/Remesher.h"
#include "Evolution/ScalarImage.h"
#include "Evolution/StallTest.h"
#include "Evolution/StepFailure.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Redistribution/StateArrays.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace evolving
{

/**
 * Steps a surface through time. The connectivity stays, and the sparse pattern is analysed once,
 * unless a remesher gives the surface new elements: after every remeshingInterval-th step,
 * smoothing steps included, and after the step that ends the flow. A state is what its step ended
 * with after that; the arrays and the record are those of the new elements.
 * @code
 *   SurfaceFlow flow(start, field, options, execution);
 *   while (!flow.isFinished()) { flow.step(); use(flow.mesh(), flow.arrays(), flow.record()); }
 *   if (!flow.stopReason().empty()) ... // ended early; the last state is good
 * @endcode
 */
class SurfaceFlow
{
public:
  /// @param field null for pure mean curvature flow. @throws InputError
  SurfaceFlow(SurfaceMesh start, std::shared_ptr<const ScalarImage> field,
    const FlowOptions& options, const Execution& execution = {});
  /// @param start shared with the states until the first remeshing
  /// @param remesher null for none
  SurfaceFlow(std::shared_ptr<const SurfaceMesh> start, std::shared_ptr<const ScalarImage> field,
    std::shared_ptr<Remesher> remesher, const FlowOptions& options,
    const Execution& execution = {});

  /// Steps with smoothing steps: the iteration of the last state when nothing stops the flow.
  int totalSteps() const;
  /**
   * True after the last step, after a stop, at an extinction, and after convergence unless
   * smoothing steps follow; then the steps up to the first smoothing step repeat the state.
   */
  bool isFinished() const;
  /// No vertex moved farther along its normal in a step than FlowSetup::restingMove, or the
  /// farthest one came no nearer to the target in stallSteps steps (looked at where remeshing is
  /// due).
  bool hasConverged() const { return this->Converged; }
  /// When the surface shrinks to a point, where that ends the flow: in the step after the state.
  /// The state is the last good surface.
  const std::optional<double>& extinctionTime() const { return this->ExtinctionTime; }
  /// Empty, or one sentence that says at which step and why the flow ended; that step is undone.
  const std::string& stopReason() const { return this->StopReason; }

  /// One time step. A step that fails, for whatever reason, leaves the state before it and sets
  /// stopReason(). @throws InputError when the first step cannot use the input. @throws Cancelled
  void step();

  const SurfaceMesh& mesh() const { return this->Surface.mesh(); }
  const StateArrays& arrays() const { return this->Arrays; }
  const FlowRecord& record() const { return this->Record; }
  /// The record of the current state, its area, volume and smallest angle for points that are
  /// handed out elsewhere; its distances are those of the state's arrays.
  FlowRecord recordAt(const std::vector<Vec3>& points) const;
  /// A copy of the current state.
  FlowState state() const;
  /**
   * Goes on from a state of an equal flow, whatever its elements. The steps after it agree with
   * those of the first to the solver tolerance: warm starts are not part of a state.
   */
  void resume(const FlowState& state);
  /// L of the relative units: the unit the options were scaled by; 1 when they are absolute.
  double lengthUnit() const { return this->Setup.lengthUnit; }
  /// As the options say, or the automatic one.
  double timeStep() const { return this->Setup.options.timeStep; }
  /// K of an image, as the options say or the automatic one, in their unit; 0 for other fields.
  double edgeSharpness() const
  {
    return this->Surface.edgeSharpness() / (this->Setup.lengthUnit * this->Setup.lengthUnit);
  }

private:
  bool isSmoothing() const;
  Execution stepExecution() const;
  void evaluate(const Execution& execution);
  void stepOrStop();
  void tidyLastState();
  std::optional<StepFailure> tryStep(int parts, const Execution& execution);
  void restore(const FlowState& state, const Execution& execution);
  void arrive(const std::vector<Vec3>& before, const Execution& execution);
  void repeatState();
  bool isVanishing() const;
  void endByExtinction();
  void countIteration();
  bool hasStoppedMoving(const std::vector<Vec3>& before) const;
  bool hasStalled();

  FlowSetup Setup;
  Execution Run;
  Vec3 Center; ///< of the start
  ExtinctionTest Extinction;
  EvolvingSurface Surface;
  StateArrays Arrays;
  FlowRecord Record;
  StallTest Stall;
  bool Converged = false;
  std::optional<double> ExtinctionTime;
  std::string StopReason;
};

} // namespace evolving

#endif
