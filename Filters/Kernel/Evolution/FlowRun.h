// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The course of an evolution: steps, retries, new elements, smoothing, convergence, early ends.
 */

#ifndef EVOLVING_FLOW_RUN_H
#define EVOLVING_FLOW_RUN_H

#include "Evolution/EvolvingSurface.h"
#include "Evolution/FlowSetup.h"
#include "Evolution/Remesher.h"
#include "Evolution/StallTest.h"
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
  FlowRun(const std::shared_ptr<const SurfaceMesh>& start, std::shared_ptr<const ScalarImage> field,
    std::shared_ptr<Remesher> remesher, const FlowSetup& setup, const Execution& execution);

  int totalSteps() const;
  bool isFinished() const;
  bool hasConverged() const { return this->Converged; }
  const std::string& stopReason() const { return this->StopReason; }

  void step();

  const SurfaceMesh& mesh() const { return this->Surface.mesh(); }
  const FlowArrays& arrays() const { return this->Arrays; }
  const FlowRecord& record() const { return this->Record; }
  FlowState state() const;
  void resume(const FlowState& state);
  double lengthUnit() const { return this->Setup.lengthUnit; }

private:
  bool isSmoothing() const;
  Execution stepExecution() const;
  void evaluate(const Execution& execution);
  void stepOrStop();
  void tidyLastState();
  std::string tryStep(int parts, const Execution& execution);
  void arrive(const std::vector<Vec3>& before, const Execution& execution);
  void repeatState();
  void countIteration();
  bool hasStoppedMoving(const std::vector<Vec3>& before) const;
  bool isRemeshingDue() const;
  bool hasStalled();

  FlowSetup Setup;
  Execution Run;
  Vec3 Center; ///< of the start
  EvolvingSurface Surface;
  FlowArrays Arrays;
  FlowRecord Record;
  StallTest Stall;
  bool Converged = false;
  std::string StopReason;
};

} // namespace evolving

#endif
