// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * All states of an evolution: solved once, kept within a memory limit, handed out in any order.
 */

#ifndef EVOLVING_STATE_SERIES_H
#define EVOLVING_STATE_SERIES_H

#include "Evolution/FlowState.h"
#include "Evolution/KeptStates.h"
#include "Evolution/SurfaceFlow.h"
#include "Execution.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace evolving
{

/**
 * The iterations whose states are published: the start, every interval-th step, the last step,
 * and in the same way the smoothing steps after it.
 * @return increasing, beginning with 0; at least one
 */
std::vector<int> publishedIterations(int steps, int smoothingSteps, int interval);

/**
 * A user looks at an evolution forwards, backwards and again; each look must not be a solve. The
 * series runs the flow once and keeps the published states. When they exceed the memory limit,
 * every second one is dropped; a dropped state is computed again from the nearest one before it.
 */
class StateSeries
{
public:
  /// Makes the flow at its start; called once, and again to recompute dropped states.
  using MakeFlow = std::function<SurfaceFlow(const Execution&)>;
  /// Sees every computed step, the start included, and a last state that was tidied once more.
  using Observe = std::function<void(const SurfaceFlow&)>;

  /**
   * Runs the flow to its end. What ends it early, lack of memory included, leaves the states
   * before and a reason.
   * @param makeFlow forgotten, with all it refers to, when no state had to be dropped
   * @param published as publishedIterations() gives them
   * @param memoryLimit bytes; the first and the last state are kept whatever it is
   * @param flowBytes what makeFlow holds in memory beside the start; counts once it must stay
   * @param observe may be empty
   * @throws InputError when there is no start, or no first step with it
   * @throws Cancelled
   */
  StateSeries(MakeFlow makeFlow, std::vector<int> published, std::size_t memoryLimit,
    const Execution& execution, std::size_t flowBytes = 0, const Observe& observe = {});

  /**
   * The state published as number i. After convergence or an early end the last state reached.
   * @throws Cancelled
   */
  std::shared_ptr<const FlowState> state(std::size_t i, const Execution& execution);

  /// One record per computed step, the start included.
  const std::vector<FlowRecord>& history() const { return this->History; }
  /// Steps that went without the volume-based redistribution, see FlowRecord::isRedistributed.
  int stepsWithoutRedistribution() const;
  /// As SurfaceFlow::stopReason().
  const std::string& stopReason() const { return this->StopReason; }
  /// As SurfaceFlow::extinctionTime().
  const std::optional<double>& extinctionTime() const { return this->ExtinctionTime; }
  /// Those published; where the surface has shrunk to a point, those up to its last state.
  std::vector<int> iterations() const;
  /// As SurfaceFlow::timeStep().
  double timeStep() const { return this->TimeStep; }
  /// As SurfaceFlow::edgeSharpness().
  double edgeSharpness() const { return this->EdgeSharpness; }
  /// The iteration of the last state reached.
  int lastIteration() const { return this->History.back().iteration; }

private:
  void run(SurfaceFlow& flow, const Execution& execution, const Observe& observe);
  bool isPublished(int iteration) const;
  void keep(const SurfaceFlow& flow);
  void endAtLastKept(const std::string& reason);

  MakeFlow Make; ///< null when all states are kept
  std::vector<int> Published;
  KeptStates States;
  std::vector<FlowRecord> History;
  std::string StopReason;
  std::optional<double> ExtinctionTime;
  double TimeStep = 0.0;
  double EdgeSharpness = 0.0;
};

} // namespace evolving

#endif
