// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/StateSeries.h"

#include "Evolution/StepFailure.h"

#include <algorithm>
#include <new>
#include <utility>

namespace evolving
{

std::vector<int> publishedIterations(int steps, int smoothingSteps, int interval)
{
  std::vector<int> iterations;
  for (int k = 0; k < steps; k += interval)
  {
    iterations.push_back(k);
  }
  iterations.push_back(steps);
  for (int k = interval; k < smoothingSteps; k += interval)
  {
    iterations.push_back(steps + k);
  }
  if (smoothingSteps > 0)
  {
    iterations.push_back(steps + smoothingSteps);
  }
  return iterations;
}

StateSeries::StateSeries(MakeFlow makeFlow, std::vector<int> published, std::size_t memoryLimit,
  const Execution& execution, std::size_t flowBytes, const Observe& observe)
  : Make(std::move(makeFlow))
  , Published(std::move(published))
  , States(memoryLimit, flowBytes)
{
  SurfaceFlow flow = this->Make(execution);
  this->TimeStep = flow.timeStep();
  this->EdgeSharpness = flow.edgeSharpness();
  try
  {
    this->run(flow, execution, observe);
  }
  catch (const std::bad_alloc&)
  {
    this->endAtLastKept(outOfMemory());
  }
  if (this->States.areAll())
  {
    this->Make = nullptr;
  }
}

void StateSeries::run(SurfaceFlow& flow, const Execution& execution, const Observe& observe)
{
  const double total = std::max(1, flow.totalSteps());
  for (;;)
  {
    const int iteration = flow.record().iteration;
    execution.report(iteration / total);
    this->History.push_back(flow.record());
    if (observe)
    {
      observe(flow);
    }
    if (this->isPublished(iteration) || flow.isFinished())
    {
      this->keep(flow);
    }
    if (flow.isFinished())
    {
      this->ExtinctionTime = flow.extinctionTime();
      return;
    }
    flow.step();
    if (flow.record().iteration == iteration)
    {
      // The step was undone: the state before it is the last one, with its final elements.
      this->StopReason = flow.stopReason();
      this->ExtinctionTime = flow.extinctionTime();
      this->History.back() = flow.record();
      this->keep(flow);
      if (observe)
      {
        observe(flow);
      }
      return;
    }
  }
}

std::vector<int> StateSeries::iterations() const
{
  std::vector<int> iterations = this->Published;
  if (this->ExtinctionTime)
  {
    const int last = this->lastIteration();
    iterations.erase(
      std::lower_bound(iterations.begin(), iterations.end(), last), iterations.end());
    iterations.push_back(last);
  }
  return iterations;
}

int StateSeries::stepsWithoutRedistribution() const
{
  // No step comes after the last state.
  return static_cast<int>(std::count_if(this->History.begin(), this->History.end() - 1,
    [](const FlowRecord& record) { return !record.isRedistributed; }));
}

/// Those kept are the first published ones.
bool StateSeries::isPublished(int iteration) const
{
  return this->States.size() < this->Published.size() &&
    iteration == this->Published[this->States.size()];
}

void StateSeries::keep(const SurfaceFlow& flow)
{
  const auto& last = this->States.last();
  const bool isKept = last && last->record.iteration == flow.record().iteration;
  auto state = std::make_shared<const FlowState>(flow.state());
  isKept ? this->States.replaceLast(std::move(state)) : this->States.append(std::move(state));
}

/// While an exception is handled that took the flow, and with it what came after.
void StateSeries::endAtLastKept(const std::string& reason)
{
  if (!this->States.last())
  {
    throw;
  }
  const int iteration = this->States.last()->record.iteration;
  this->StopReason = endSentence(iteration + 1, reason);
  const auto isLater = [iteration](const FlowRecord& record)
  { return record.iteration > iteration; };
  this->History.erase(
    std::find_if(this->History.begin(), this->History.end(), isLater), this->History.end());
}

std::shared_ptr<const FlowState> StateSeries::state(std::size_t i, const Execution& execution)
{
  i = std::min(i, this->States.size() - 1);
  const auto& before = this->States.upTo(i);
  if (before == this->States.last() || before->record.iteration == this->Published[i])
  {
    return before;
  }
  SurfaceFlow flow = this->Make(execution);
  flow.resume(*before);
  while (flow.record().iteration < this->Published[i] && !flow.isFinished())
  {
    flow.step();
  }
  return std::make_shared<const FlowState>(flow.state());
}

} // namespace evolving
