// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceFlow.h"

#include "Errors.h"
#include "Evolution/FlowStepper.h"
#include "Evolution/ParallelLoops.h"
#include "Evolution/StateCheck.h"
#include "Evolution/StateMeasures.h"
#include "Evolution/SubSteps.h"

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

/// L: half the diagonal of the box of the target, or of the start where there is none to measure.
double sizeOf(const SurfaceMesh& start, const ScalarImage* field, FieldMode mode)
{
  Box box;
  if (field && mode == FieldMode::DistanceField)
  {
    box = field->insideBox();
  }
  if (box.isEmpty() || !(box.diagonal().norm() > 0.0))
  {
    box = boundingBox(start);
  }
  return 0.5 * box.diagonal().norm();
}

void checkStart(const SurfaceMesh& start)
{
  validate(start);
  if (start.faceCount() == 0 || !(surfaceArea(start) > 0.0))
  {
    std::ostringstream message;
    message << "The start surface has " << start.faceCount() << " faces with a total area of "
            << surfaceArea(start) << ", expected faces of positive area.";
    throw InputError(message.str());
  }
}

double advectionRate(const FlowOptions& options, const ScalarImage* field)
{
  const bool isExplicit = field && options.fieldMode == FieldMode::DistanceField;
  const double D = options.advectionBalance;
  return isExplicit ? options.advectionSpeed * std::sqrt(1.0 + D * D) : 0.0;
}

/// The options with rates that a sub-step bears.
FlowOptions withLimitedRates(
  const FlowOptions& options, const ScalarImage* field, const SubSteps& parts)
{
  FlowOptions limited = options;
  limited.redistribution = limitRates(options.redistribution, parts.timeStep);
  const double rate = advectionRate(options, field) * parts.timeStep;
  limited.advectionSpeed /= std::max(1.0, rate / ExplicitLimits::Advection);
  return limited;
}

std::unique_ptr<FlowStepper> makeStepper(SurfaceMesh start,
  std::shared_ptr<const ScalarImage> field, const FlowOptions& options, double size,
  const SubSteps& parts, const Execution& execution)
{
  const FlowOptions limited = withLimitedRates(options, field.get(), parts);
  return std::make_unique<FlowStepper>(
    std::move(start), std::move(field), limited, size, parts.timeStep, execution);
}

} // namespace

struct SurfaceFlow::State
{
  FlowOptions Options; ///< in absolute units
  double Size = 1.0;   ///< L, also with absolute units
  double LengthUnit = 1.0;
  SubSteps Parts;
  Execution Run;
  std::unique_ptr<FlowStepper> Stepper;
  StateCheck Check;
  FlowArrays Arrays;
  FlowRecord Record;
  bool HasVelocities = false; ///< the stepper's are those of its position
  bool Converged = false;
  std::string StopReason;

  int totalSteps() const { return this->Options.numberOfSteps + this->Options.smoothingSteps; }

  bool isSmoothing() const
  {
    return this->Options.smoothingSteps > 0 &&
      this->Record.iteration >= this->Options.numberOfSteps;
  }

  /// Progress and stop requests of step `iteration + 1`.
  Execution stepExecution() const
  {
    const double total = std::max(1, this->totalSteps());
    return this->Run.phase(this->Record.iteration / total, (this->Record.iteration + 1) / total);
  }

  /// Velocities for the step after the current state, or its part.
  void evaluate(const Execution& execution)
  {
    if (this->isSmoothing())
    {
      const int k = this->Record.iteration - this->Options.numberOfSteps;
      this->Stepper->evaluateSmoothing(
        smoothingControl(this->Options.smoothingSpeed, this->Options.smoothingDecay, k), execution);
    }
    else
    {
      this->Stepper->evaluateFlow(execution);
    }
    this->HasVelocities = true;
    this->Record.solverIterations += this->Stepper->evaluationIterations();
  }

  /// The arrays and numbers of the evaluated state.
  void publish();
  void attempt(int parts, const Execution& execution);
  bool hasStoppedMoving(const std::vector<Vec3>& before, const std::vector<Vec3>& normals) const;
  void stepOnce();
  /// Returns why it failed; empty when it did not.
  std::string tryStep(int parts);
  void beginIteration(const std::vector<Vec3>& before, const Execution& execution);
  void countIteration();
  void repeatState();
};

void SurfaceFlow::State::publish()
{
  this->Arrays = this->Stepper->arrays();
  measureState(this->Stepper->mesh(), this->Arrays, this->Record, this->Run);
}

void SurfaceFlow::State::attempt(int parts, const Execution& execution)
{
  const double tau = this->Options.timeStep / parts;
  for (int part = 0; part < parts; ++part)
  {
    const double done = static_cast<double>(part) / parts;
    const Execution now = execution.phase(done, done + 1.0 / parts);
    now.report(0.0);
    if (!this->HasVelocities)
    {
      this->evaluate(now.phase(0.0, 0.5));
    }
    const std::vector<Vec3> before = this->Stepper->mesh().points;
    this->HasVelocities = false;
    this->Stepper->advance(tau, now.phase(0.5, 1.0));
    this->Record.solverIterations += this->Stepper->advanceIterations();
    this->Check.require(this->Stepper->mesh(), before, now);
  }
}

bool SurfaceFlow::State::hasStoppedMoving(
  const std::vector<Vec3>& before, const std::vector<Vec3>& normals) const
{
  double farthest = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    const Vec3 move = this->Stepper->mesh().points[i] - before[i];
    farthest = std::max(farthest, std::abs(move.dot(normals[i])));
  }
  return farthest < this->Options.convergenceTolerance * this->Size;
}

void SurfaceFlow::State::stepOnce()
{
  std::string failure;
  for (int halvings = 0; halvings <= MostHalvings; ++halvings)
  {
    failure = this->tryStep(this->Parts.count << halvings);
    if (failure.empty())
    {
      return;
    }
  }
  std::ostringstream message;
  message << "The evolution ended before step " << this->Record.iteration + 1 << ": " << failure;
  this->StopReason = message.str();
}

std::string SurfaceFlow::State::tryStep(int parts)
{
  const SurfacePosition positionBefore = this->Stepper->position();
  const FlowRecord recordBefore = this->Record;
  const auto undo = [&]()
  {
    this->Stepper->setPosition(positionBefore);
    this->Record = recordBefore;
    this->HasVelocities = false;
  };
  const Execution execution = this->stepExecution();
  this->Record.solverIterations = 0;
  try
  {
    this->attempt(parts, execution.phase(0.0, 0.9));
    this->beginIteration(positionBefore.points, execution.phase(0.9, 1.0));
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

void SurfaceFlow::State::beginIteration(const std::vector<Vec3>& before, const Execution& execution)
{
  const bool converged =
    !this->isSmoothing() && this->hasStoppedMoving(before, this->Arrays.normal);
  this->countIteration();
  this->evaluate(execution);
  this->publish();
  this->Converged = this->Converged || converged;
}

void SurfaceFlow::State::countIteration()
{
  ++this->Record.iteration;
  this->Record.time = this->Record.iteration * this->Options.timeStep;
}

void SurfaceFlow::State::repeatState()
{
  this->countIteration();
  this->Record.solverIterations = 0;
  if (this->isSmoothing())
  {
    this->evaluate(this->stepExecution());
    this->publish();
  }
}

SurfaceFlow::SurfaceFlow(SurfaceMesh start, std::shared_ptr<const ScalarImage> field,
  const FlowOptions& options, const Execution& execution)
  : Self(std::make_unique<State>())
{
  checkOptions(options);
  checkStart(start);
  State& s = *this->Self;
  s.Size = sizeOf(start, field.get(), options.fieldMode);
  s.LengthUnit = options.relativeUnits ? s.Size : 1.0;
  s.Options = inAbsoluteUnits(options, s.LengthUnit);
  s.Parts =
    divideStep(options.timeStep, options.redistribution, advectionRate(s.Options, field.get()));
  s.Run = execution;
  s.Check = StateCheck(start, field ? 0.0 : options.surfaceGuard);
  s.Stepper =
    makeStepper(std::move(start), std::move(field), s.Options, s.Size, s.Parts, execution);
  s.evaluate(execution.phase(0.0, 0.0));
  s.publish();
}

SurfaceFlow::~SurfaceFlow() = default;
SurfaceFlow::SurfaceFlow(SurfaceFlow&&) noexcept = default;
SurfaceFlow& SurfaceFlow::operator=(SurfaceFlow&&) noexcept = default;

int SurfaceFlow::totalSteps() const
{
  return this->Self->totalSteps();
}

bool SurfaceFlow::isFinished() const
{
  const State& s = *this->Self;
  return !s.StopReason.empty() || s.Record.iteration >= s.totalSteps() ||
    (s.Converged && s.Options.smoothingSteps == 0);
}

bool SurfaceFlow::hasConverged() const
{
  return this->Self->Converged;
}

const std::string& SurfaceFlow::stopReason() const
{
  return this->Self->StopReason;
}

void SurfaceFlow::step()
{
  if (this->isFinished())
  {
    return;
  }
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  State& s = *this->Self;
  if (s.Converged && !s.isSmoothing())
  {
    s.repeatState();
  }
  else
  {
    s.stepOnce();
  }
  s.Record.seconds = std::chrono::duration<double>(Clock::now() - start).count();
}

const SurfaceMesh& SurfaceFlow::mesh() const
{
  return this->Self->Stepper->mesh();
}

const FlowArrays& SurfaceFlow::arrays() const
{
  return this->Self->Arrays;
}

const FlowRecord& SurfaceFlow::record() const
{
  return this->Self->Record;
}

FlowState SurfaceFlow::state() const
{
  const SurfacePosition position = this->Self->Stepper->position();
  return { position.points, position.onCurves, this->Self->Arrays, this->Self->Record };
}

void SurfaceFlow::resume(const FlowState& state)
{
  State& s = *this->Self;
  s.Stepper->setPosition({ state.points, state.curvePositions });
  s.Record = state.record;
  s.Converged = false;
  s.StopReason.clear();
  s.evaluate(s.stepExecution());
  s.publish();
  s.Record = state.record;
}

double SurfaceFlow::lengthUnit() const
{
  return this->Self->LengthUnit;
}

} // namespace evolving
