// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A state of an evolving surface: where it is, and what is known about it.
 */

#ifndef EVOLVING_FLOW_STATE_H
#define EVOLVING_FLOW_STATE_H

#include "Evolution/StallTest.h"
#include "Mesh/SurfaceMesh.h"
#include "Redistribution/StateArrays.h"

#include <memory>
#include <vector>

namespace evolving
{

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
  /// False where the step after the state goes without the volume-based redistribution, for which
  /// no potential could be solved for.
  bool isRedistributed = true;
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
  StateArrays arrays;
  FlowRecord record;
  StallTest stall; ///< for resume() only
  bool hasConverged = false;
  /// For every vertex of the origin the point of the start that it came from; null while the
  /// elements are the start's, and without FlowOptions::tracesStart.
  std::shared_ptr<const std::vector<Vec3>> startPoints;

  /// The origin's faces at the state's points.
  SurfaceMesh mesh() const;
};

} // namespace evolving

#endif
