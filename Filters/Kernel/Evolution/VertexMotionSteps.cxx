// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// How VertexMotion moves the points, once it has their velocities.

#include "Evolution/VertexMotion.h"

#include "Errors.h"
#include "Operators/EnclosedVolume.h"
#include "ParallelLoops.h"

#include <algorithm>

namespace evolving
{

namespace
{

/// What the limiter of inversions takes from a volume is given back, and looked at again: this
/// often.
constexpr int VolumeRounds = 5;

} // namespace

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
    for (std::size_t i = 0; i < this->Mesh.points.size(); ++i)
    {
      this->LastMove.limited.displacement[i] =
        this->Mesh.points[i] - this->LastMove.before.points[i];
    }
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
  const std::vector<double>* stiffness =
    this->Controls.stiffness.empty() ? nullptr : &this->Controls.stiffness;
  std::vector<Vec3> velocity(count);
  std::vector<Vec3> known(count);
  forEachIndex(execution, this->Mesh.vertexCount(),
    [&](Index i)
    {
      // What is linearized is the motion along the normal alone.
      const double damping = stiffness ? 1.0 + timeStep * (*stiffness)[at(i)] : 1.0;
      velocity[at(i)] = this->GivenVelocity[at(i)] + damping * this->TangentVelocity[at(i)];
      known[at(i)] = slid[at(i)] - this->Mesh.points[at(i)];
    });
  this->LastMove.limited.displacement = this->Step.displacement(this->Geometry,
    { this->Controls.epsilon, velocity, isKnown, known, timeStep, stiffness },
    this->Options.solverTolerance, execution);
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
}

void VertexMotion::limitLastMove(const std::vector<Vec3>& before, const Execution& execution)
{
  this->Vanished.update(this->Mesh);
  for (int round = 0; round < VolumeRounds; ++round)
  {
    this->Limiter.limit(
      this->Mesh, before, this->Geometry.normals(), this->LastMove.limited,
      [&] { this->redoLastMove(execution); }, execution);
    if (!this->Volumes)
    {
      return;
    }
    this->restoreVolumes(execution);
    if (!this->Limiter.hasTurned(this->Mesh, before, execution))
    {
      return;
    }
  }
  throw SolverError("the volume could not be held without turning faces over, expected moves that "
                    "are small beside the elements; use a shorter time step.");
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

} // namespace evolving
