// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/EvolvingSurface.h"

#include "Errors.h"
#include "VolumeFlows/HeldVolumes.h"

#include <optional>
#include <string>
#include <utility>

namespace evolving
{

EvolvingSurface::EvolvingSurface(std::shared_ptr<const SurfaceMesh> start,
  std::shared_ptr<const ScalarImage> field, std::shared_ptr<Remesher> remesher,
  const FlowSetup& setup, const Execution& execution)
  : Setup(setup)
  , Guard(*start, field ? field->box() : Box(), setup.options.surfaceGuard)
  , Field(std::make_unique<ControlField>(std::move(field), setup.options, execution))
  , NewElements(std::move(remesher))
{
  if (this->NewElements && setup.options.tracesStart)
  {
    this->Trace = std::make_unique<const StartTrace>(*start, execution);
  }
  this->setElements(std::move(start), execution);
  this->SmallestComponent = this->Motion->smallestComponentArea();
}

void EvolvingSurface::setElements(
  std::shared_ptr<const SurfaceMesh> origin, const Execution& execution)
{
  this->Motion = std::make_unique<VertexMotion>(*origin, *this->Field, this->Setup.options,
    this->Setup.size, this->Setup.parts.timeStep, this->SmallestComponent, execution);
  this->Origin = std::move(origin);
  this->HasVelocities = false;
}

double EvolvingSurface::areaAt(const std::vector<Vec3>& points, const Execution& execution) const
{
  SurfaceMesh mesh = this->mesh();
  mesh.points = points;
  if (mesh.hasOnlyTriangles())
  {
    return surfaceArea(mesh);
  }
  // Polygons that are not planar have the area of the triangles around their virtual vertices.
  FiniteVolumes volumes = this->Motion->geometry().volumes();
  volumes.update(mesh, execution);
  return totalArea(volumes.coVolumes(), execution);
}

void EvolvingSurface::setPlace(const SurfacePlace& place, const Execution& execution)
{
  if (place.origin != this->Origin && !(*place.origin == *this->Origin))
  {
    this->setElements(place.origin, execution);
  }
  this->Origin = place.origin; // states that have it share it again
  this->StartPoints = place.startPoints;
  this->Motion->setPosition(place.position);
  this->HasVelocities = false;
}

void EvolvingSurface::evaluate(int iteration, const Execution& execution)
{
  const FlowOptions& o = this->Setup.options;
  if (o.isSmoothing(iteration))
  {
    const int k = iteration - o.numberOfSteps;
    this->Motion->evaluateSmoothing(
      smoothingControl(o.smoothingSpeed, o.smoothingDecay, k), execution);
  }
  else
  {
    this->Motion->evaluateFlow(execution);
  }
  this->HasVelocities = true;
  this->SolverIterations += this->Motion->evaluationIterations();
}

void EvolvingSurface::move(int iteration, int parts, const Execution& execution)
{
  const double tau = this->Setup.options.timeStep / parts;
  const std::vector<Vec3> before = this->mesh().points;
  for (int part = 0; part < parts; ++part)
  {
    const double done = static_cast<double>(part) / parts;
    const Execution now = execution.phase(done, done + 1.0 / parts);
    now.report(0.0);
    if (!this->HasVelocities)
    {
      this->evaluate(iteration, now.phase(0.0, 0.5));
    }
    this->HasVelocities = false;
    this->Motion->advance(tau, now.phase(0.5, 1.0));
    this->SolverIterations += this->Motion->advanceIterations();
    this->Guard.require(this->mesh(), now);
    this->Motion->limitLastMove(before, now);
  }
}

std::shared_ptr<const std::vector<Vec3>> EvolvingSurface::traceStart(
  const SurfaceMesh& remeshed, const Execution& execution) const
{
  if (!this->Trace)
  {
    return nullptr;
  }
  // The elements that are not new are those of the start: the origin is the start.
  const std::vector<Vec3>& old = this->StartPoints ? *this->StartPoints : this->Origin->points;
  return std::make_shared<const std::vector<Vec3>>(
    this->Trace->carryOver(this->mesh(), old, remeshed, execution));
}

bool EvolvingSurface::remesh(bool isLast, const Execution& execution)
{
  if (!this->NewElements)
  {
    return false;
  }
  const std::vector<double> distance =
    this->Field->valuesAt(this->mesh().points, execution.phase(0.0, 0.1));
  std::optional<SurfaceMesh> remeshed = this->NewElements->remesh(
    { this->mesh(), this->Origin->points, distance, isLast, this->Field->target() },
    execution.phase(0.1, 0.8));
  if (!remeshed)
  {
    return false;
  }
  try
  {
    validate(*remeshed);
    auto startPoints = this->traceStart(*remeshed, execution.phase(0.8, 0.8));
    giveBackVolumes(this->Motion->heldVolumes(), *remeshed, execution.phase(0.8, 0.8));
    this->setElements(
      std::make_shared<const SurfaceMesh>(std::move(*remeshed)), execution.phase(0.8, 0.9));
    this->StartPoints = std::move(startPoints);
    this->Guard.require(this->mesh(), execution.phase(0.9, 1.0));
  }
  catch (const SurfaceVanished&)
  {
    // The flow had left one.
    throw SolverError("remeshing made no surface that can be evolved, expected one with an area.");
  }
  catch (const InputError& error)
  {
    throw SolverError(
      std::string("remeshing made no surface that can be evolved: ") + error.what());
  }
  return true;
}

} // namespace evolving
