// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/TangentialVelocity.h"

#include "ParallelLoops.h"
#include "Redistribution/AngleRedistribution.h"

#include <algorithm>

namespace evolving
{

namespace
{

constexpr double LargestPartOfEdge = 0.5;
/// psi only says where points go on the surface: more digits would not be seen.
constexpr double FinestPotentialTolerance = 1e-8;

void add(const std::vector<Vec3>& part, std::vector<Vec3>& sum, const Execution& execution)
{
  forEachIndex(
    execution, static_cast<std::int64_t>(sum.size()), [&](Index i) { sum[at(i)] += part[at(i)]; });
}

/// No more than the mean below, at a sixth of its cost.
double leastMeanRingLength(const SurfaceMesh& mesh, const MeshTopology& topology, Index vertex)
{
  const MeshTopology::Run ring = topology.ringVertices(vertex);
  return ring.size() > 0 ? (mesh.points[at(ring[0])] - mesh.points[at(vertex)]).norm() / ring.size()
                         : 0.0;
}

double meanRingLength(const SurfaceMesh& mesh, const MeshTopology& topology, Index vertex)
{
  double sum = 0.0;
  const MeshTopology::Run ring = topology.ringVertices(vertex);
  for (const Index j : ring)
  {
    sum += (mesh.points[at(j)] - mesh.points[at(vertex)]).norm();
  }
  return ring.size() > 0 ? sum / ring.size() : 0.0;
}

} // namespace

TangentialVelocity::TangentialVelocity(const MeshTopology& topology, const SurfaceCurves& curves,
  const RedistributionOptions& options, BoundaryMode boundaryMode, double solverTolerance)
  : Curves(curves)
  , Options(options)
  , Boundary(boundaryMode)
  , SolverTolerance(std::max(solverTolerance, FinestPotentialTolerance))
  , Volume(topology)
{
  if (options.length > 0.0)
  {
    this->Length.emplace_back(topology, curves);
  }
}

std::vector<Vec3> TangentialVelocity::velocity(
  const TangentialInput& input, const Execution& execution)
{
  std::vector<Vec3> velocity(input.mesh.points.size(), Vec3::Zero());
  if (this->Options.isActive())
  {
    const std::vector<Vec3> tangents = this->Curves.tangents(input.mesh.points);
    this->addParts(input, tangents, velocity, execution);
    this->limit(input, tangents, velocity, execution);
  }
  return velocity;
}

void TangentialVelocity::dropVolume()
{
  this->Options.volume = 0.0;
  this->Volume.forget();
}

void TangentialVelocity::addParts(const TangentialInput& input, const std::vector<Vec3>& tangents,
  std::vector<Vec3>& velocity, const Execution& execution)
{
  const RedistributionOptions& o = this->Options;
  if (o.volume > 0.0)
  {
    add(this->Volume.velocity(input.mesh, input.geometry, input.normalVelocity, o, input.timeStep,
          this->SolverTolerance, execution),
      velocity, execution);
  }
  if (o.angle > 0.0)
  {
    add(angleRedistribution(input.mesh, input.geometry, tangents, o, input.distance,
          input.distanceScale, input.timeStep, execution),
      velocity, execution);
  }
  for (const LengthRedistribution& length : this->Length)
  {
    add(length.velocity(input.mesh, input.geometry.normals(), input.normalVelocity, o.length,
          1.0 / input.timeStep, execution),
      velocity, execution);
  }
}

void TangentialVelocity::limit(const TangentialInput& input, const std::vector<Vec3>& tangents,
  std::vector<Vec3>& velocity, const Execution& execution) const
{
  const MeshTopology& topology = input.geometry.topology();
  forEachIndex(execution, input.mesh.vertexCount(),
    [&](Index i)
    {
      Vec3& v = velocity[at(i)];
      const bool isBoundary = topology.isBoundary(i);
      if (isBoundary && this->Boundary == BoundaryMode::Fixed)
      {
        v.setZero();
      }
      else if (this->Curves.isOnCurve(i) && !(isBoundary && this->Boundary == BoundaryMode::Free))
      {
        v = tangents[at(i)] * tangents[at(i)].dot(v); // a corner has no tangent
      }
      const double length = input.timeStep * v.norm();
      if (length <= LargestPartOfEdge * leastMeanRingLength(input.mesh, topology, i))
      {
        return; // nearly all
      }
      const double farthest = LargestPartOfEdge * meanRingLength(input.mesh, topology, i);
      v *= length > farthest ? farthest / length : 1.0;
    });
}

} // namespace evolving
