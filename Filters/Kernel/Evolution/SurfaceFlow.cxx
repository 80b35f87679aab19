// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceFlow.h"

#include "Errors.h"
#include "Evolution/StateMeasures.h"
#include "Evolution/StepRetry.h"
#include "Mesh/MeshQuality.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <string>
#include <utility>

namespace evolving
{

SurfaceFlow::SurfaceFlow(SurfaceMesh start, std::shared_ptr<const ScalarImage> field,
  const FlowOptions& options, const Execution& execution)
  : SurfaceFlow(std::make_shared<const SurfaceMesh>(std::move(start)), std::move(field), nullptr,
      options, execution)
{
}

SurfaceFlow::SurfaceFlow(std::shared_ptr<const SurfaceMesh> start,
  std::shared_ptr<const ScalarImage> field, std::shared_ptr<Remesher> remesher,
  const FlowOptions& options, const Execution& execution)
  : Setup(setUpFlow(*start, field.get(), options))
  , Run(execution)
  , Center(boundingBox(*start).center())
  , Extinction(*start, field != nullptr, this->Setup.options)
  , Surface(std::move(start), std::move(field), std::move(remesher), this->Setup,
      execution.phase(0.0, 0.0))
{
  try
  {
    this->evaluate(execution.phase(0.0, 0.0));
  }
  catch (const SolverError& error)
  {
    throw InputError(std::string("The start surface cannot be evolved: ") + error.what());
  }
  this->hasStalled(); // looks at the start
  this->Extinction.begin(this->Record, this->Arrays);
  if (this->isVanishing())
  {
    this->endByExtinction();
  }
}

int SurfaceFlow::totalSteps() const
{
  return this->Setup.options.totalSteps();
}

bool SurfaceFlow::isFinished() const
{
  return !this->StopReason.empty() || this->ExtinctionTime ||
    this->Record.iteration >= this->totalSteps() ||
    (this->Converged && this->Setup.options.smoothingSteps == 0);
}

bool SurfaceFlow::isSmoothing() const
{
  return this->Setup.options.isSmoothing(this->Record.iteration);
}

/// Progress and stop requests of the next step.
Execution SurfaceFlow::stepExecution() const
{
  const double total = std::max(1, this->totalSteps());
  return this->Run.phase(this->Record.iteration / total, (this->Record.iteration + 1) / total);
}

/// Velocities for the step after the current state, and the state's arrays and numbers.
void SurfaceFlow::evaluate(const Execution& execution)
{
  this->Surface.evaluate(this->Record.iteration, execution);
  this->Arrays = this->Surface.arrays();
  this->Record.solverIterations = this->Surface.solverIterations();
  this->Record.isRedistributed = this->Surface.isRedistributed();
  measureState(this->mesh(), this->Center, this->Arrays, this->Record, this->Run);
}

FlowRecord SurfaceFlow::recordAt(const std::vector<Vec3>& points) const
{
  const Execution now = this->stepExecution().phase(0.0, 0.0);
  SurfaceMesh mesh = this->mesh();
  mesh.points = points;
  FlowRecord record = this->Record;
  record.area = this->Surface.areaAt(points, now);
  record.volume = signedVolume(mesh, this->Center);
  record.minAngle = smallestAngle(mesh, now);
  return record;
}

void SurfaceFlow::step()
{
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  if (this->isFinished())
  {
    return;
  }
  this->Surface.resetSolverIterations();
  if (this->Converged && !this->isSmoothing())
  {
    this->repeatState();
  }
  else
  {
    this->stepOrStop();
  }
  if (this->StopReason.empty())
  {
    this->Record.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  }
}

void SurfaceFlow::stepOrStop()
{
  // Progress never goes back: that of the first try stands.
  const Execution all = this->stepExecution();
  const std::optional<StepFailure> failure = tryInMoreParts(this->Setup.parts.count,
    [&](int parts, bool isFirst)
    { return this->tryStep(parts, isFirst ? all : all.phase(1.0, 1.0)); });
  if (!failure)
  {
    return;
  }
  if (failure->isOfInput && this->Record.iteration == 0)
  {
    throw InputError(failure->reason); // nothing but the input has been reached
  }
  if (failure->isExtinction || this->Extinction.isNearlyGone(this->Record))
  {
    this->endByExtinction();
  }
  else
  {
    this->StopReason = endSentence(this->Record.iteration + 1, failure->reason);
  }
  this->tidyLastState();
}

/// The state before the step that failed is the last one; it stays as it is when that fails, too.
void SurfaceFlow::tidyLastState()
{
  const FlowState before = this->state();
  try
  {
    const Execution now = this->stepExecution().phase(1.0, 1.0);
    if (this->Surface.remesh(true, now))
    {
      this->evaluate(now);
      this->Record.solverIterations = before.record.solverIterations; // as of the step to it
    }
  }
  catch (...)
  {
    this->restore(before, Execution());
    failureOf(std::current_exception());
  }
}

/// Returns why the step failed, and undoes it then; nothing when it did not.
std::optional<StepFailure> SurfaceFlow::tryStep(int parts, const Execution& execution)
{
  const FlowState before = this->state();
  this->Surface.resetSolverIterations();
  try
  {
    this->Surface.move(this->Record.iteration, parts, execution.phase(0.0, 0.9));
    this->arrive(before.points, execution.phase(0.9, 1.0));
    return std::nullopt;
  }
  catch (...)
  {
    this->restore(before, Execution());
    return failureOf(std::current_exception());
  }
}

/// The surface is where the step ends: gives it new elements, and looks whether it is there.
void SurfaceFlow::arrive(const std::vector<Vec3>& before, const Execution& execution)
{
  const bool isTowardsTarget = !this->isSmoothing();
  const bool hasStopped = isTowardsTarget && this->hasStoppedMoving(before);
  this->countIteration();
  const bool isLast = hasStopped || this->Record.iteration == this->totalSteps();
  const bool isRenewed = isLast || this->Setup.options.isRemeshingDue(this->Record.iteration);
  if (isRenewed)
  {
    this->Surface.remesh(isLast, execution.phase(0.0, 0.4));
  }
  this->evaluate(execution.phase(0.4, 0.5));
  const bool isStuck = isTowardsTarget && isRenewed && this->hasStalled();
  const bool isVanishing = this->isVanishing();
  if ((isStuck || isVanishing) && !isLast)
  {
    this->Surface.remesh(true, execution.phase(0.5, 0.9));
    this->evaluate(execution.phase(0.9, 1.0));
  }
  this->Converged = this->Converged || hasStopped || isStuck;
  if (isVanishing)
  {
    this->endByExtinction();
  }
}

/// Would the next step be the one in which the surface shrinks to a point?
bool SurfaceFlow::isVanishing() const
{
  return this->Record.iteration < this->Setup.options.numberOfSteps &&
    this->Extinction.isLastBefore(this->Record, this->Arrays);
}

void SurfaceFlow::endByExtinction()
{
  const double left = this->Extinction.timeLeft(this->Record, this->Arrays);
  this->ExtinctionTime = this->Record.time + std::min(left, this->Setup.options.timeStep);
}

bool SurfaceFlow::hasStoppedMoving(const std::vector<Vec3>& before) const
{
  return farthestNormalMove(before, this->mesh().points, this->Arrays.normal) <
    this->Setup.restingMove;
}

/// Intensities of an edge detector are no distances.
bool SurfaceFlow::hasStalled()
{
  const FlowOptions& o = this->Setup.options;
  const bool hasDistances =
    o.fieldMode == FieldMode::DistanceField && !this->Arrays.distance.empty();
  return hasDistances && o.stallSteps > 0 &&
    this->Stall.hasStalled(this->Record.iteration, this->Record.maxDistance, o.stallSteps);
}

/// A converged state waits for the smoothing steps.
void SurfaceFlow::repeatState()
{
  this->stepExecution().report(0.0);
  this->countIteration();
  this->Record.solverIterations = 0;
  if (this->isSmoothing())
  {
    this->evaluate(this->stepExecution());
  }
}

void SurfaceFlow::countIteration()
{
  ++this->Record.iteration;
  this->Record.time = this->Record.iteration * this->Setup.options.timeStep;
}

FlowState SurfaceFlow::state() const
{
  SurfacePlace place = this->Surface.place();
  return { std::move(place.origin), std::move(place.position.points),
    std::move(place.position.onCurves), this->Arrays, this->Record, this->Stall, this->Converged,
    std::move(place.startPoints) };
}

void SurfaceFlow::restore(const FlowState& state, const Execution& execution)
{
  this->Surface.setPlace(
    { state.origin, { state.points, state.curvePositions, state.record.isRedistributed },
      state.startPoints },
    execution);
  this->Arrays = state.arrays;
  this->Record = state.record;
  this->Stall = state.stall;
  this->Converged = state.hasConverged;
}

void SurfaceFlow::resume(const FlowState& state)
{
  this->Record.iteration = state.record.iteration; // of which the progress is told
  const Execution execution = this->stepExecution();
  this->restore(state, execution);
  this->StopReason.clear();
  this->ExtinctionTime.reset();
  this->evaluate(execution);
  this->Record = state.record;
}

} // namespace evolving
