// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/FlowStepper.h"

#include "Evolution/ParallelLoops.h"

#include <utility>

namespace evolving
{

FlowStepper::FlowStepper(SurfaceMesh start, std::shared_ptr<const ScalarImage> field,
  const FlowOptions& options, double size, double timeStep, const Execution& execution)
  : Mesh(std::move(start))
  , Options(options)
  , Size(size)
  , TimeStep(timeStep)
  , Topology(this->Mesh)
  , Curves(this->Mesh, this->Topology)
  , OnCurves(this->Curves.startPositions())
  , Geometry(this->Topology)
  , Field(std::move(field), options, execution)
  , Tangential(this->Topology, this->Curves, options.redistribution, options.boundaryMode,
      options.solverTolerance)
  , NormalVelocity(this->Mesh.points.size())
{
}

void FlowStepper::setPosition(const SurfacePosition& position)
{
  this->Mesh.points = position.points;
  this->OnCurves = position.onCurves;
}

bool FlowStepper::isHeld(Index vertex) const
{
  const bool isBoundary = this->Topology.isBoundary(vertex);
  return !this->Topology.isUsed(vertex) ||
    (isBoundary && this->Options.boundaryMode != BoundaryMode::Free);
}

void FlowStepper::evaluateFlow(const Execution& execution)
{
  this->Geometry.update(this->Mesh, execution);
  this->Controls = this->Field.evaluate(this->Mesh.points, this->Geometry.normals(), execution);
  this->evaluateVelocities(execution);
}

void FlowStepper::evaluateSmoothing(double epsilon, const Execution& execution)
{
  this->Geometry.update(this->Mesh, execution);
  this->Controls = this->Field.evaluateSmoothing(this->Mesh.points, epsilon, execution);
  this->evaluateVelocities(execution);
}

void FlowStepper::evaluateVelocities(const Execution& execution)
{
  forEachIndex(execution, this->Mesh.vertexCount(),
    [this](Index i)
    {
      this->NormalVelocity[at(i)] = this->isHeld(i)
        ? Vec3(Vec3::Zero())
        : Vec3(this->Controls.epsilon[at(i)] * this->Geometry.curvatureVectors()[at(i)] +
            this->Controls.eta[at(i)] * this->Geometry.normals()[at(i)]);
    });
  const TangentialInput input{ this->Mesh, this->Geometry, this->NormalVelocity,
    this->Controls.value, this->Size, this->TimeStep };
  this->TangentVelocity = this->Tangential.velocity(input, execution);
}

void FlowStepper::advance(double timeStep, const Execution& execution)
{
  const std::size_t count = this->Mesh.points.size();
  std::vector<Vec3> slid = this->Mesh.points;
  if (this->Options.boundaryMode == BoundaryMode::SlideAlong)
  {
    this->Curves.slide(this->TangentVelocity, timeStep, this->OnCurves, slid);
  }
  std::vector<Vec3> velocity(count);
  std::vector<char> isKnown(count);
  std::vector<Vec3> known(count);
  forEachIndex(execution, this->Mesh.vertexCount(),
    [&](Index i)
    {
      velocity[at(i)] =
        this->Controls.eta[at(i)] * this->Geometry.normals()[at(i)] + this->TangentVelocity[at(i)];
      isKnown[at(i)] = this->isHeld(i);
      known[at(i)] = slid[at(i)] - this->Mesh.points[at(i)];
    });
  const std::vector<Vec3>& displacement = this->Step.displacement(this->Geometry,
    { this->Controls.epsilon, velocity, isKnown, known, timeStep }, this->Options.solverTolerance,
    execution);
  forEachIndex(execution, this->Mesh.vertexCount(),
    [&](Index i)
    {
      // Held vertices are exactly where the curve says, others where the step ends.
      Vec3& point = this->Mesh.points[at(i)];
      point = isKnown[at(i)] ? slid[at(i)] : Vec3(point + displacement[at(i)]);
    });
}

FlowArrays FlowStepper::arrays() const
{
  FlowArrays arrays;
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
