// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StepSystems.h"

#include "Algebra/ConjugateGradients.h"
#include "Operators/SurfaceGeometry.h"
#include "Redistribution/VolumeRedistribution.h"

namespace benchmark
{

namespace
{

using evolving::SurfaceGeometry;

const evolving::Execution OneThread;

void fillPositions(const SurfaceGeometry& geometry, double tau, StepSystems& systems)
{
  const std::vector<double>& mu = geometry.coVolumes();
  systems.positionMatrix = tau * geometry.volumes().stiffness();
  for (std::size_t i = 0; i < mu.size(); ++i)
  {
    systems.positionMatrix.coeffRef(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) +=
      mu[i];
    systems.positionRightHandSide.emplace_back(tau * mu[i] * geometry.curvatureVectors()[i]);
  }
}

void fillPotential(const SurfaceGeometry& geometry, double tau, StepSystems& systems)
{
  const std::vector<double>& mu = geometry.coVolumes();
  const std::vector<double> wanted(
    mu.size(), evolving::totalArea(mu, OneThread) / static_cast<double>(mu.size()));
  std::vector<double>& b = systems.potentialRightHandSide;
  b = evolving::redistributionRightHandSide(
    geometry, geometry.curvatureVectors(), wanted, 1.0, 1.0 / tau, OneThread);
  for (double& value : b)
  {
    value = -value;
  }
  systems.stiffness = geometry.volumes().stiffness();
  systems.isPinned.assign(mu.size(), 0);
  systems.isPinned.front() = 1;
  systems.potentialMatrix = systems.stiffness;
  evolving::eliminateKnown(
    systems.isPinned, std::vector<double>(mu.size(), 0.0), systems.potentialMatrix, b, OneThread);
}

} // namespace

StepSystems systemsOfStep(const evolving::SurfaceMesh& mesh, double tau)
{
  const evolving::MeshTopology topology(mesh);
  SurfaceGeometry geometry(topology);
  geometry.update(mesh, OneThread);
  StepSystems systems;
  fillPositions(geometry, tau, systems);
  fillPotential(geometry, tau, systems);
  return systems;
}

evolving::SurfaceMesh afterStep(evolving::SurfaceMesh mesh, const StepSystems& systems)
{
  std::vector<evolving::Vec3> displacement(mesh.points.size(), evolving::Vec3::Zero());
  evolving::conjugateGradients(systems.positionMatrix, systems.positionRightHandSide, displacement,
    evolving::SolverLimits(), OneThread);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    mesh.points[i] += displacement[i];
  }
  return mesh;
}

} // namespace benchmark
