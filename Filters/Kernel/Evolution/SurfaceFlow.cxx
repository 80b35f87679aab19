// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceFlow.h"

#include "Evolution/FlowRun.h"
#include "Evolution/FlowSetup.h"

#include <utility>

namespace evolving
{

struct SurfaceFlow::State : public FlowRun
{
  using FlowRun::FlowRun;
};

SurfaceMesh FlowState::mesh() const
{
  SurfaceMesh mesh = *this->origin;
  mesh.points = this->points;
  return mesh;
}

SurfaceFlow::SurfaceFlow(SurfaceMesh start, std::shared_ptr<const ScalarImage> field,
  const FlowOptions& options, const Execution& execution)
  : SurfaceFlow(std::make_shared<const SurfaceMesh>(std::move(start)), std::move(field), nullptr,
      options, execution)
{
}

SurfaceFlow::SurfaceFlow(std::shared_ptr<const SurfaceMesh> start,
  std::shared_ptr<const ScalarImage> field, std::shared_ptr<Remesher> remesher,
  const FlowOptions& options, const Execution& execution)
{
  const FlowSetup setup = setUpFlow(*start, field.get(), options);
  this->Self =
    std::make_unique<State>(start, std::move(field), std::move(remesher), setup, execution);
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
  return this->Self->isFinished();
}

bool SurfaceFlow::hasConverged() const
{
  return this->Self->hasConverged();
}

const std::string& SurfaceFlow::stopReason() const
{
  return this->Self->stopReason();
}

void SurfaceFlow::step()
{
  this->Self->step();
}

const SurfaceMesh& SurfaceFlow::mesh() const
{
  return this->Self->mesh();
}

const FlowArrays& SurfaceFlow::arrays() const
{
  return this->Self->arrays();
}

const FlowRecord& SurfaceFlow::record() const
{
  return this->Self->record();
}

FlowState SurfaceFlow::state() const
{
  return this->Self->state();
}

void SurfaceFlow::resume(const FlowState& state)
{
  this->Self->resume(state);
}

double SurfaceFlow::lengthUnit() const
{
  return this->Self->lengthUnit();
}

} // namespace evolving
