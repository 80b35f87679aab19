// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The evolution of a surface in time: d_t F = epsilon Laplace F + eta N + v_T (4.1), from the
 * start surface to the last smoothing step.
 */

#ifndef EVOLVING_SURFACE_FLOW_H
#define EVOLVING_SURFACE_FLOW_H

#include "Evolution/FlowOptions.h"
#include "Evolution/Remesher.h"
#include "Evolution/ScalarImage.h"
#include "Evolution/StallTest.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"

#include <memory>
#include <string>
#include <vector>

namespace evolving
{

/// One value per vertex (or 3), as they were used to compute the step *after* the state.
struct FlowArrays
{
  std::vector<double> distance;       ///< the field's value; empty without a field
  std::vector<Vec3> distanceGradient; ///< normalized; empty without a field
  std::vector<Vec3> normal;
  std::vector<double> meanCurvature; ///< -h.N: +2/r on a sphere
  std::vector<double> coVolume;
  std::vector<double> normalVelocity; ///< epsilon h.N + eta
  std::vector<Vec3> tangentialVelocity;
  std::vector<double> redistributionPotential; ///< psi
};

/// The numbers of one step: the field arrays and a row of the history.
struct FlowRecord
{
  int iteration = 0;
  double time = 0.0;
  double area = 0.0;
  double volume = 0.0;
  double meanDistance = 0.0; ///< of |d| over the surface; 0 without a field
  double maxDistance = 0.0;
  double minAngle = 0.0; ///< degrees
  int solverIterations = 0;
  double seconds = 0.0; ///< wall time of the step
};

/// A state of the flow with all that belongs to it.
struct FlowState
{
  /// The surface when it got its elements: the start, or as it was last remeshed. All states until
  /// the next remeshing share it.
  std::shared_ptr<const SurfaceMesh> origin;
  std::vector<Vec3> points;
  std::vector<double> curvePositions; ///< of boundary vertices that slide: for resume() only
  FlowArrays arrays;
  FlowRecord record;
  StallTest stall; ///< for resume() only
  bool hasConverged = false;

  /// The origin's faces at the state's points.
  SurfaceMesh mesh() const;
};

/**
 * Steps a surface through time. The connectivity stays, and the sparse pattern is analysed once,
 * unless a remesher gives the surface new elements: after every remeshingInterval-th step,
 * smoothing steps included, and after the step that ends the run. A state is what its step ended
 * with after that; the arrays and the record are those of the new elements.
 * @code
 *   SurfaceFlow flow(start, field, options, execution);
 *   while (!flow.isFinished()) { flow.step(); use(flow.points(), flow.arrays(), flow.record()); }
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
  ~SurfaceFlow();
  SurfaceFlow(SurfaceFlow&&) noexcept;
  SurfaceFlow& operator=(SurfaceFlow&&) noexcept;

  /// Steps with smoothing steps: the iteration of the last state when nothing stops the run.
  int totalSteps() const;
  /**
   * True after the last step, after a stop, and after convergence unless smoothing steps follow;
   * then the steps up to the first smoothing step repeat the state.
   */
  bool isFinished() const;
  /// No vertex moved farther along its normal in a step than convergenceTolerance, or the farthest
  /// one came no nearer to the target in stallSteps steps (looked at where remeshing is due).
  bool hasConverged() const;
  /// Empty, or one sentence that says at which step and why the run ended; that step is undone.
  const std::string& stopReason() const;

  /// One time step. A step that fails leaves the state before it and sets stopReason().
  /// @throws Cancelled
  void step();

  const SurfaceMesh& mesh() const;
  const FlowArrays& arrays() const;
  const FlowRecord& record() const;
  /// A copy of the current state.
  FlowState state() const;
  /**
   * Goes on from a state of an equal flow, whatever its elements. The steps after it agree with
   * the first run's to the solver tolerance: warm starts are not part of a state.
   */
  void resume(const FlowState& state);
  /// L of the relative units: the unit the options were scaled by; 1 when they are absolute.
  double lengthUnit() const;

private:
  struct State;
  std::unique_ptr<State> Self;
};

} // namespace evolving

#endif
