// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/VertexMotion.h"

#include "Errors.h"
#include "Evolution/AdvectionLimit.h"
#include "Mesh/VertexNormals.h"
#include "Operators/EnclosedVolume.h"
#include "ParallelLoops.h"
#include "VolumeFlows/VolumeFlux.h"

#include <algorithm>
#include <utility>

namespace evolving
{

VertexMotion::VertexMotion(SurfaceMesh start, const ControlField& field, const FlowOptions& options,
  double size, double timeStep, double smallestComponent, const Execution& execution)
  : Mesh(std::move(start))
  , Options(options)
  , Size(size)
  , TimeStep(timeStep)
  , Topology(this->Mesh)
  , Curves(this->Mesh, this->Topology)
  , OnCurves(this->Curves.startPositions())
  , Vanished(this->Mesh, this->Topology, smallestComponent)
  , Limiter(this->Mesh, this->Topology, angleWeightedNormals(this->Mesh, this->Topology, execution),
      this->Vanished)
  , Geometry(this->Topology)
  , Field(field)
  , Tangential(this->Topology, this->Curves, options.redistribution, options.boundaryMode,
      options.solverTolerance)
  , Diffusion(options.curvatureSpeed, options.solverTolerance)
  , NormalVelocity(this->Mesh.points.size())
{
  if (options.holdsVolume())
  {
    this->Volumes.emplace(this->Mesh, this->Topology);
  }
}

std::vector<double> VertexMotion::heldVolumes() const
{
  return this->Volumes ? this->Volumes->volumes() : std::vector<double>();
}

void VertexMotion::setPosition(const SurfacePosition& position)
{
  this->Mesh.points = position.points;
  this->OnCurves = position.onCurves;
  if (!position.isRedistributed)
  {
    this->dropVolumeRedistribution();
  }
}

bool VertexMotion::isHeld(Index vertex) const
{
  const bool isBoundary = this->Topology.isBoundary(vertex);
  return !this->Topology.isUsed(vertex) || this->Vanished.contain(vertex) ||
    (isBoundary && this->Options.boundaryMode != BoundaryMode::Free);
}

std::vector<char> VertexMotion::heldVertices() const
{
  std::vector<char> held(this->Mesh.points.size());
  for (Index i = 0; i < this->Mesh.vertexCount(); ++i)
  {
    held[at(i)] = this->isHeld(i) ? 1 : 0;
  }
  return held;
}

void VertexMotion::evaluateFlow(const Execution& execution)
{
  this->Vanished.update(this->Mesh);
  this->Geometry.update(this->Mesh, execution);
  this->Controls = this->Field.evaluate(this->Mesh.points, this->Geometry.normals(), execution);
  if (this->Options.flow == Flow::SurfaceDiffusion)
  {
    this->takeDiffusion(execution);
  }
  else
  {
    this->Field.limitAdvection(this->TimeStep, this->Controls);
    limitByEdges(this->Mesh, this->Topology, this->Options.longestAdvection, this->TimeStep,
      this->Controls.eta, execution);
    this->takeControls(execution);
  }
  this->evaluateVelocities(execution);
}

void VertexMotion::takeControls(const Execution& execution)
{
  this->DiffusionIterations = 0;
  this->GivenVelocity.resize(this->Mesh.points.size());
  forEachIndex(execution, this->Mesh.vertexCount(),
    [this](Index i)
    { this->GivenVelocity[at(i)] = this->Controls.eta[at(i)] * this->Geometry.normals()[at(i)]; });
}

/// A step of it is solved here, so that redistribution knows the velocities that the step has.
void VertexMotion::takeDiffusion(const Execution& execution)
{
  this->Controls.epsilon.assign(this->Mesh.points.size(), 0.0);
  this->GivenVelocity = this->Diffusion.velocity(
    this->Mesh, this->Geometry, this->heldVertices(), this->TimeStep, execution);
  this->DiffusionIterations = this->Diffusion.iterations();
}

void VertexMotion::evaluateSmoothing(double epsilon, const Execution& execution)
{
  this->Geometry.update(this->Mesh, execution);
  this->Controls = this->Field.evaluateSmoothing(this->Mesh.points, epsilon, execution);
  this->Vanished.update(this->Mesh);
  this->takeControls(execution);
  this->evaluateVelocities(execution);
}

void VertexMotion::evaluateVelocities(const Execution& execution)
{
  forEachIndex(execution, this->Mesh.vertexCount(),
    [this](Index i)
    {
      this->NormalVelocity[at(i)] = this->isHeld(i)
        ? Vec3(Vec3::Zero())
        : Vec3(this->Controls.epsilon[at(i)] * this->Geometry.curvatureVectors()[at(i)] +
            this->GivenVelocity[at(i)]);
    });
  if (this->Volumes)
  {
    removeVolumeFlux(this->Geometry, this->heldVertices(), this->NormalVelocity);
  }
  this->evaluateTangential(execution);
  forEachIndex(execution, this->Mesh.vertexCount(),
    [this](Index i)
    {
      if (this->Vanished.contain(i))
      {
        this->TangentVelocity[at(i)].setZero();
      }
    });
}

/// Good elements matter less than that the flow goes on: it may need none, or new ones, later.
void VertexMotion::evaluateTangential(const Execution& execution)
{
  const TangentialInput input{ this->Mesh, this->Geometry, this->NormalVelocity,
    this->Controls.value, this->Size, this->TimeStep };
  try
  {
    this->TangentVelocity = this->Tangential.velocity(input, execution);
  }
  catch (const SolverError&)
  {
    this->dropVolumeRedistribution();
    this->TangentVelocity = this->Tangential.velocity(input, execution);
  }
}

/// Until there are new elements: a solve that fails takes as long as a hundred that do not.
void VertexMotion::dropVolumeRedistribution()
{
  this->IsRedistributed = false;
  this->Tangential.dropVolume();
}

/// What a unit of a multiplier adds to the move of a step, before it is made.
std::vector<Vec3> VertexMotion::responseToVolume(const Execution& execution)
{
  const std::vector<double>& epsilon = this->Controls.epsilon;
  const bool isImplicit = *std::max_element(epsilon.begin(), epsilon.end()) > 0.0;
  if (isImplicit)
  {
    return this->Step.response(
      volumeGradient(this->Mesh), this->Options.solverTolerance, execution);
  }
  std::vector<Vec3> normals = this->Geometry.normals();
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    normals[i] *= this->LastMove.isHeld[i] ? 0.0 : 1.0;
  }
  return normals;
}

/// After a step, along its own response.
void VertexMotion::restoreVolumes(const Execution& execution)
{
  if (this->Volumes)
  {
    execution.report(0.0);
    this->Volumes->restore(this->Mesh, this->LastMove.response);
  }
}

/// Where held vertices go; OnCurves follows.
std::vector<Vec3> VertexMotion::slide(const std::vector<Vec3>& velocity, double timeStep)
{
  std::vector<Vec3> slid = this->Mesh.points;
  if (this->Options.boundaryMode == BoundaryMode::SlideAlong)
  {
    this->Curves.slide(velocity, timeStep, this->OnCurves, slid);
  }
  return slid;
}

void VertexMotion::advance(double timeStep, const Execution& execution)
{
  this->LastMove.before = this->position();
  this->LastMove.timeStep = timeStep;
  const std::size_t count = this->Mesh.points.size();
  this->LastMove.isHeld = this->heldVertices();
  const std::vector<char>& isKnown = this->LastMove.isHeld;
  const std::vector<Vec3> slid = this->slide(this->TangentVelocity, timeStep);
  std::vector<Vec3> velocity(count);
  std::vector<Vec3> known(count);
  forEachIndex(execution, this->Mesh.vertexCount(),
    [&](Index i)
    {
      velocity[at(i)] = this->GivenVelocity[at(i)] + this->TangentVelocity[at(i)];
      known[at(i)] = slid[at(i)] - this->Mesh.points[at(i)];
    });
  this->LastMove.limited.displacement = this->Step.displacement(this->Geometry,
    { this->Controls.epsilon, velocity, isKnown, known, timeStep }, this->Options.solverTolerance,
    execution);
  if (this->Volumes)
  {
    this->LastMove.response = this->responseToVolume(execution);
  }
  forEachIndex(execution, this->Mesh.vertexCount(),
    [&](Index i)
    {
      // Held vertices are exactly where the curve says, others where the step ends.
      Vec3& point = this->Mesh.points[at(i)];
      point =
        isKnown[at(i)] ? slid[at(i)] : Vec3(point + this->LastMove.limited.displacement[at(i)]);
    });
  this->restoreVolumes(execution);
  for (std::size_t i = 0; this->Volumes && i < count; ++i)
  {
    this->LastMove.limited.displacement[i] = this->Mesh.points[i] - this->LastMove.before.points[i];
  }
}

void VertexMotion::limitLastMove(const std::vector<Vec3>& before, const Execution& execution)
{
  this->Vanished.update(this->Mesh);
  this->Limiter.limit(
    this->Mesh, before, this->Geometry.normals(), this->LastMove.limited,
    [&] { this->redoLastMove(execution); }, execution);
  this->restoreVolumes(execution);
}

/// As the limiter changed it; held vertices only know how far they slide.
void VertexMotion::redoLastMove(const Execution& execution)
{
  const LimitedMove& move = this->LastMove.limited;
  this->setPosition(this->LastMove.before);
  std::vector<Vec3> shortened(move.fraction.size());
  forEachIndex(execution, this->Mesh.vertexCount(),
    [&](Index i) { shortened[at(i)] = move.fraction[at(i)] * this->TangentVelocity[at(i)]; });
  const std::vector<Vec3> slid = this->slide(shortened, this->LastMove.timeStep);
  forEachIndex(execution, this->Mesh.vertexCount(),
    [&](Index i)
    {
      Vec3& point = this->Mesh.points[at(i)];
      const Vec3 moved = point + move.fraction[at(i)] * move.displacement[at(i)];
      point = this->LastMove.isHeld[at(i)] ? slid[at(i)] : moved;
    });
}

StateArrays VertexMotion::arrays() const
{
  StateArrays arrays;
  arrays.distance = this->Controls.value;
  arrays.distanceGradient = this->Controls.gradient;
  arrays.normal = this->Geometry.normals();
  arrays.coVolume = this->Geometry.coVolumes();
  arrays.tangentialVelocity = this->TangentVelocity;
  arrays.redistributionPotential = this->Tangential.potential();
  for (Index i = 0; i < this->Mesh.vertexCount(); ++i)
  {
    arrays.meanCurvature.push_back(this->Geometry.meanCurvature(i));
    arrays.normalVelocity.push_back(
      this->NormalVelocity[at(i)].dot(this->Geometry.normals()[at(i)]));
  }
  return arrays;
}

} // namespace evolving
