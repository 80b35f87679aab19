// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/VertexMotion.h"

#include "Mesh/VertexNormals.h"
#include "ParallelLoops.h"

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
  , NormalVelocity(this->Mesh.points.size())
{
}

void VertexMotion::setPosition(const SurfacePosition& position)
{
  this->Mesh.points = position.points;
  this->OnCurves = position.onCurves;
}

bool VertexMotion::isHeld(Index vertex) const
{
  const bool isBoundary = this->Topology.isBoundary(vertex);
  return !this->Topology.isUsed(vertex) || this->Vanished.contain(vertex) ||
    (isBoundary && this->Options.boundaryMode != BoundaryMode::Free);
}

void VertexMotion::evaluateFlow(const Execution& execution)
{
  this->Geometry.update(this->Mesh, execution);
  this->Controls = this->Field.evaluate(this->Mesh.points, this->Geometry.normals(), execution);
  this->Field.limitAdvection(this->TimeStep, this->Controls);
  this->limitAdvection(execution);
  this->evaluateVelocities(execution);
}

/// Elements that move by more than their own length fold where the directions meet.
void VertexMotion::limitAdvection(const Execution& execution)
{
  if (this->Options.longestAdvection == 0.0)
  {
    return;
  }
  forEachIndex(execution, this->Mesh.vertexCount(),
    [this](Index i)
    {
      const MeshTopology::Run ring = this->Topology.ringVertices(i);
      double lengths = 0.0;
      for (const Index j : ring)
      {
        lengths += (this->Mesh.points[at(j)] - this->Mesh.points[at(i)]).norm();
      }
      const double fastest =
        this->Options.longestAdvection * lengths / std::max(1, ring.size()) / this->TimeStep;
      double& eta = this->Controls.eta[at(i)];
      eta = std::clamp(eta, -fastest, fastest);
    });
}

void VertexMotion::evaluateSmoothing(double epsilon, const Execution& execution)
{
  this->Geometry.update(this->Mesh, execution);
  this->Controls = this->Field.evaluateSmoothing(this->Mesh.points, epsilon, execution);
  this->evaluateVelocities(execution);
}

void VertexMotion::evaluateVelocities(const Execution& execution)
{
  this->Vanished.update(this->Mesh);
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
  forEachIndex(execution, this->Mesh.vertexCount(),
    [this](Index i)
    {
      if (this->Vanished.contain(i))
      {
        this->TangentVelocity[at(i)].setZero();
      }
    });
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
  std::vector<char>& isKnown = this->LastMove.isHeld;
  isKnown.resize(count);
  const std::vector<Vec3> slid = this->slide(this->TangentVelocity, timeStep);
  std::vector<Vec3> velocity(count);
  std::vector<Vec3> known(count);
  forEachIndex(execution, this->Mesh.vertexCount(),
    [&](Index i)
    {
      velocity[at(i)] =
        this->Controls.eta[at(i)] * this->Geometry.normals()[at(i)] + this->TangentVelocity[at(i)];
      isKnown[at(i)] = this->isHeld(i);
      known[at(i)] = slid[at(i)] - this->Mesh.points[at(i)];
    });
  this->LastMove.limited.displacement = this->Step.displacement(this->Geometry,
    { this->Controls.epsilon, velocity, isKnown, known, timeStep }, this->Options.solverTolerance,
    execution);
  forEachIndex(execution, this->Mesh.vertexCount(),
    [&](Index i)
    {
      // Held vertices are exactly where the curve says, others where the step ends.
      Vec3& point = this->Mesh.points[at(i)];
      point =
        isKnown[at(i)] ? slid[at(i)] : Vec3(point + this->LastMove.limited.displacement[at(i)]);
    });
}

void VertexMotion::limitLastMove(const std::vector<Vec3>& before, const Execution& execution)
{
  this->Vanished.update(this->Mesh);
  this->Limiter.limit(
    this->Mesh, before, this->Geometry.normals(), this->LastMove.limited,
    [&] { this->redoLastMove(execution); }, execution);
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
