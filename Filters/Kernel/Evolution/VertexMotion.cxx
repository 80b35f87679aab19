// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/VertexMotion.h"

#include "Errors.h"
#include "Evolution/AdvectionLimit.h"
#include "Evolution/BlurredEdges.h"
#include "Mesh/VertexNormals.h"
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
  this->Controls =
    this->Field.evaluate(onBlurredEdges(this->Mesh, this->Geometry, this->Field.edgeBlur()),
      this->Geometry.normals(), execution);
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
