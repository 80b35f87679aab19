// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/FlowRun.h"

#include "Errors.h"
#include "Evolution/StateMeasures.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>
#include <utility>

namespace evolving
{

namespace
{

/// A step that fails is tried again in 2, 4, 8 and 16 times as many parts.
constexpr int MostHalvings = 4;

} // namespace

FlowRun::FlowRun(SurfaceMesh start, std::shared_ptr<const ScalarImage> field,
  const FlowSetup& setup, const Execution& execution)
  : Setup(setup)
  , Run(execution)
  , Center(boundingBox(start).center())
  , Check(start, field ? field->box() : Box(), setup.options.surfaceGuard)
  , Stepper(std::move(start), std::move(field), setup.options, setup.size, setup.parts.timeStep,
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
  this->publish();
}

int FlowRun::totalSteps() const
{
  return this->Setup.options.numberOfSteps + this->Setup.options.smoothingSteps;
}

bool FlowRun::isFinished() const
{
  return !this->StopReason.empty() || this->Record.iteration >= this->totalSteps() ||
    (this->Converged && this->Setup.options.smoothingSteps == 0);
}

bool FlowRun::isSmoothing() const
{
  return this->Setup.options.smoothingSteps > 0 &&
    this->Record.iteration >= this->Setup.options.numberOfSteps;
}

/// Progress and stop requests of the next step.
Execution FlowRun::stepExecution() const
{
  const double total = std::max(1, this->totalSteps());
  return this->Run.phase(this->Record.iteration / total, (this->Record.iteration + 1) / total);
}

/// Velocities for the step after the current state, or its next part.
void FlowRun::evaluate(const Execution& execution)
{
  const FlowOptions& o = this->Setup.options;
  if (this->isSmoothing())
  {
    const int k = this->Record.iteration - o.numberOfSteps;
    this->Stepper.evaluateSmoothing(
      smoothingControl(o.smoothingSpeed, o.smoothingDecay, k), execution);
  }
  else
  {
    this->Stepper.evaluateFlow(execution);
  }
  this->HasVelocities = true;
  this->Record.solverIterations += this->Stepper.evaluationIterations();
}

void FlowRun::publish()
{
  this->Arrays = this->Stepper.arrays();
  measureState(this->mesh(), this->Center, this->Arrays, this->Record, this->Run);
}

void FlowRun::step()
{
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  if (this->isFinished())
  {
    return;
  }
  if (this->Converged && !this->isSmoothing())
  {
    this->repeatState();
  }
  else
  {
    this->stepOrStop();
  }
  this->Record.seconds = std::chrono::duration<double>(Clock::now() - start).count();
}

void FlowRun::stepOrStop()
{
  std::string failure;
  for (int halvings = 0; halvings <= MostHalvings; ++halvings)
  {
    failure = this->tryStep(this->Setup.parts.count << halvings);
    if (failure.empty())
    {
      return;
    }
  }
  std::ostringstream message;
  message << "The evolution ended before step " << this->Record.iteration + 1 << ": " << failure;
  this->StopReason = message.str();
}

/// Returns why the step failed, and undoes it then; empty when it did not.
std::string FlowRun::tryStep(int parts)
{
  const SurfacePosition positionBefore = this->Stepper.position();
  const FlowRecord recordBefore = this->Record;
  const auto undo = [&]()
  {
    this->Stepper.setPosition(positionBefore);
    this->Record = recordBefore;
    this->HasVelocities = false;
  };
  const Execution execution = this->stepExecution();
  this->Record.solverIterations = 0;
  try
  {
    this->moveInParts(parts, positionBefore.points, execution.phase(0.0, 0.9));
    this->arrive(positionBefore.points, execution.phase(0.9, 1.0));
    return {};
  }
  catch (const SolverError& error)
  {
    undo();
    return error.what();
  }
  catch (...)
  {
    undo();
    throw;
  }
}

void FlowRun::moveInParts(int parts, const std::vector<Vec3>& before, const Execution& execution)
{
  const double tau = this->Setup.options.timeStep / parts;
  for (int part = 0; part < parts; ++part)
  {
    const double done = static_cast<double>(part) / parts;
    const Execution now = execution.phase(done, done + 1.0 / parts);
    now.report(0.0);
    if (!this->HasVelocities)
    {
      this->evaluate(now.phase(0.0, 0.5));
    }
    this->HasVelocities = false;
    this->Stepper.advance(tau, now.phase(0.5, 1.0));
    this->Record.solverIterations += this->Stepper.advanceIterations();
    this->Check.require(this->mesh(), now);
    this->Stepper.limitLastMove(before, now);
  }
}

void FlowRun::arrive(const std::vector<Vec3>& before, const Execution& execution)
{
  const bool converged = !this->isSmoothing() && this->hasStoppedMoving(before);
  this->countIteration();
  this->evaluate(execution);
  this->publish();
  this->Converged = this->Converged || converged;
}

bool FlowRun::hasStoppedMoving(const std::vector<Vec3>& before) const
{
  double farthest = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    const Vec3 move = this->mesh().points[i] - before[i];
    farthest = std::max(farthest, std::abs(move.dot(this->Arrays.normal[i])));
  }
  return farthest < this->Setup.options.convergenceTolerance * this->Setup.size;
}

/// A converged state waits for the smoothing steps.
void FlowRun::repeatState()
{
  this->stepExecution().report(0.0);
  this->countIteration();
  this->Record.solverIterations = 0;
  if (this->isSmoothing())
  {
    this->evaluate(this->stepExecution());
    this->publish();
  }
}

void FlowRun::countIteration()
{
  ++this->Record.iteration;
  this->Record.time = this->Record.iteration * this->Setup.options.timeStep;
}

FlowState FlowRun::state() const
{
  const SurfacePosition position = this->Stepper.position();
  return { position.points, position.onCurves, this->Arrays, this->Record };
}

void FlowRun::resume(const FlowState& state)
{
  this->Stepper.setPosition({ state.points, state.curvePositions });
  this->Record = state.record;
  this->Converged = false;
  this->StopReason.clear();
  this->evaluate(this->stepExecution());
  this->publish();
  this->Record = state.record;
}

} // namespace evolving
