// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The course of an evolution: steps, retries, smoothing, convergence and early ends.
 */

#ifndef EVOLVING_FLOW_RUN_H
#define EVOLVING_FLOW_RUN_H

#include "Evolution/FlowSetup.h"
#include "Evolution/FlowStepper.h"
#include "Evolution/StateCheck.h"
#include "Evolution/SurfaceFlow.h"
#include "Execution.h"

#include <memory>
#include <string>
#include <vector>

namespace evolving
{

/// What SurfaceFlow does, see there.
class FlowRun
{
public:
  FlowRun(SurfaceMesh start, std::shared_ptr<const ScalarImage> field, const FlowSetup& setup,
    const Execution& execution);

  int totalSteps() const;
  bool isFinished() const;
  bool hasConverged() const { return this->Converged; }
  const std::string& stopReason() const { return this->StopReason; }

  void step();

  const SurfaceMesh& mesh() const { return this->Stepper.mesh(); }
  const FlowArrays& arrays() const { return this->Arrays; }
  const FlowRecord& record() const { return this->Record; }
  FlowState state() const;
  void resume(const FlowState& state);
  double lengthUnit() const { return this->Setup.lengthUnit; }

private:
  bool isSmoothing() const;
  Execution stepExecution() const;
  void evaluate(const Execution& execution);
  void publish();
  void stepOrStop();
  std::string tryStep(int parts);
  void moveInParts(int parts, const std::vector<Vec3>& before, const Execution& execution);
  void arrive(const std::vector<Vec3>& before, const Execution& execution);
  void repeatState();
  void countIteration();
  bool hasStoppedMoving(const std::vector<Vec3>& before) const;

  FlowSetup Setup;
  Execution Run;
  Vec3 Center; ///< of the start
  StateCheck Check;
  FlowStepper Stepper;
  bool HasVelocities = false; ///< the stepper's are those of its position
  FlowArrays Arrays;
  FlowRecord Record;
  bool Converged = false;
  std::string StopReason;
};

} // namespace evolving

#endif
