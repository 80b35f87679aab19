// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/StateSeries.h"

#include <algorithm>
#include <utility>

namespace evolving
{

namespace
{

/// Without its origin, which it shares.
std::size_t bytesOf(const FlowState& state)
{
  const StateArrays& arrays = state.arrays;
  const std::size_t vectors = state.points.size() + arrays.distanceGradient.size() +
    arrays.normal.size() + arrays.tangentialVelocity.size();
  const std::size_t scalars = state.curvePositions.size() + arrays.distance.size() +
    arrays.meanCurvature.size() + arrays.coVolume.size() + arrays.normalVelocity.size() +
    arrays.redistributionPotential.size();
  return vectors * sizeof(Vec3) + scalars * sizeof(double);
}

std::size_t bytesOf(const SurfaceMesh& mesh)
{
  return mesh.points.size() * sizeof(Vec3) +
    (mesh.faceOffsets.size() + mesh.cornerVertices.size()) * sizeof(Index);
}

/// States that share an origin follow each other.
std::size_t bytesOf(const std::vector<std::shared_ptr<const FlowState>>& states)
{
  std::size_t bytes = 0;
  const SurfaceMesh* counted = nullptr;
  for (const auto& state : states)
  {
    if (state)
    {
      bytes += bytesOf(*state);
      bytes += state->origin.get() == counted ? 0 : bytesOf(*state->origin);
      counted = state->origin.get();
    }
  }
  return bytes;
}

} // namespace

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
  const Execution& execution, const Observe& observe)
  : Make(std::move(makeFlow))
  , Published(std::move(published))
  , MemoryLimit(memoryLimit)
{
  SurfaceFlow flow = this->Make(execution);
  const double total = std::max(1, flow.totalSteps());
  std::size_t next = 0;
  for (;;)
  {
    execution.report(flow.record().iteration / total);
    this->History.push_back(flow.record());
    if (observe)
    {
      observe(flow);
    }
    const bool isPublished =
      next < this->Published.size() && flow.record().iteration == this->Published[next];
    if (isPublished || flow.isFinished())
    {
      this->keep(next++, flow);
    }
    if (flow.isFinished())
    {
      break;
    }
    flow.step();
    if (!flow.stopReason().empty())
    {
      // The step was undone, and the state before it, the last one, was tidied.
      this->History.back() = flow.record();
      this->keep(next++, flow);
      if (observe)
      {
        observe(flow);
      }
      break;
    }
  }
  this->StopReason = flow.stopReason();
}

void StateSeries::keep(std::size_t i, const SurfaceFlow& flow)
{
  const bool isTidied =
    !this->States.empty() && this->States.back()->record.iteration == flow.record().iteration;
  i = isTidied ? this->States.size() - 1 : i;
  // What was the last state is one among others now.
  this->dropBetweenStrides();
  this->States.resize(i + 1);
  this->States[i] = std::make_shared<const FlowState>(flow.state());
  this->thinOut();
}

void StateSeries::thinOut()
{
  while (bytesOf(this->States) > this->MemoryLimit && this->Stride < this->States.size())
  {
    this->Stride *= 2;
    const std::shared_ptr<const FlowState> last = this->States.back();
    this->dropBetweenStrides();
    this->States.back() = last;
  }
}

void StateSeries::dropBetweenStrides()
{
  for (std::size_t i = 0; i < this->States.size(); ++i)
  {
    if (i % this->Stride != 0)
    {
      this->States[i] = nullptr;
    }
  }
}

std::shared_ptr<const FlowState> StateSeries::state(std::size_t i, const Execution& execution)
{
  i = std::min(i, this->States.size() - 1);
  if (this->States[i])
  {
    return this->States[i];
  }
  std::size_t before = i;
  while (!this->States[before])
  {
    --before;
  }
  SurfaceFlow flow = this->Make(execution);
  flow.resume(*this->States[before]);
  while (flow.record().iteration < this->Published[i] && !flow.isFinished())
  {
    flow.step();
  }
  return std::make_shared<const FlowState>(flow.state());
}

} // namespace evolving
