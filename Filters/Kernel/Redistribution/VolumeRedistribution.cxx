// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/VolumeRedistribution.h"

#include "Operators/SurfaceGradient.h"
#include "ParallelLoops.h"
#include "Redistribution/CurvatureDensity.h"

#include <algorithm>

namespace evolving
{

namespace
{

/// The first vertex of every component, and vertices without faces, whose rows are empty.
std::vector<char> pinnedVertices(const MeshTopology& topology)
{
  std::vector<char> pinned(at(topology.vertexCount()), 0);
  std::vector<char> seen(at(topology.componentCount()), 0);
  for (Index i = 0; i < topology.vertexCount(); ++i)
  {
    const Index component = topology.componentOfVertex()[at(i)];
    pinned[at(i)] = component == NoIndex || !seen[at(component)];
    if (component != NoIndex)
    {
      seen[at(component)] = 1;
    }
  }
  return pinned;
}

} // namespace

std::vector<double> redistributionRightHandSide(const SurfaceGeometry& geometry,
  const std::vector<Vec3>& normalVelocity, const std::vector<double>& wanted, double rate,
  double largestRate, const Execution& execution)
{
  const std::vector<Index>& component = geometry.topology().componentOfVertex();
  const std::vector<double>& mu = geometry.coVolumes();
  std::vector<double> b(mu.size(), 0.0);
  forEachIndex(execution, static_cast<std::int64_t>(mu.size()),
    [&](Index i)
    {
      const double loss = normalVelocity[at(i)].dot(geometry.curvatureVectors()[at(i)]);
      b[at(i)] = mu[at(i)] * std::clamp(loss, -largestRate, largestRate);
    });
  std::vector<double> area(at(geometry.topology().componentCount()), 0.0);
  std::vector<double> loss(area.size(), 0.0);
  for (std::size_t i = 0; i < mu.size(); ++i)
  {
    if (component[i] != NoIndex)
    {
      area[at(component[i])] += mu[i];
      loss[at(component[i])] += b[i];
    }
  }
  forEachIndex(execution, static_cast<std::int64_t>(mu.size()),
    [&](Index i)
    {
      const Index c = component[at(i)];
      b[at(i)] = c == NoIndex
        ? 0.0
        : b[at(i)] - mu[at(i)] / area[at(c)] * loss[at(c)] + rate * (wanted[at(i)] - mu[at(i)]);
    });
  return b;
}

VolumeRedistribution::VolumeRedistribution(const MeshTopology& topology)
  : IsPinned(pinnedVertices(topology))
  , Psi(this->IsPinned.size(), 0.0)
{
}

void VolumeRedistribution::forget()
{
  std::fill(this->Psi.begin(), this->Psi.end(), 0.0);
  this->Iterations = 0;
}

std::vector<Vec3> VolumeRedistribution::velocity(const SurfaceMesh& mesh,
  const SurfaceGeometry& geometry, const std::vector<Vec3>& normalVelocity,
  const RedistributionOptions& options, double timeStep, double tolerance,
  const Execution& execution)
{
  const std::vector<double> wanted =
    wantedCoVolumes(geometry, options.curvatureControl, options.curvatureControlAlpha, execution);
  std::vector<double> b = redistributionRightHandSide(
    geometry, normalVelocity, wanted, options.volume, 1.0 / timeStep, execution);
  for (double& value : b)
  {
    value = -value; // L psi = -(...)
  }
  SolverLimits limits;
  limits.tolerance = tolerance;
  this->Guess.extrapolate(this->Psi, execution);
  this->Iterations = this->Solver.solve(
    geometry.volumes().stiffness(), this->IsPinned, std::move(b), this->Psi, limits, execution);

  std::vector<Vec3> velocity = surfaceGradient(mesh, geometry.volumes(), this->Psi, execution);
  forEachIndex(execution, mesh.vertexCount(),
    [&](Index i) { velocity[at(i)] = tangentialPart(velocity[at(i)], geometry.normals()[at(i)]); });
  return velocity;
}

} // namespace evolving
