// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "VolumeFlows/SurfaceDiffusion.h"

#include "Operators/EnclosedVolume.h"
#include "ParallelLoops.h"
#include "VolumeFlows/DiffusionSystem.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// Of mu_i: m_i where faces lie back to back, and their vector areas add up to nothing.
constexpr double SmallestArea = 1e-6;

/// Vertices may move along one line each.
struct Directions
{
  std::vector<Vec3> normal;
  std::vector<double> area; ///< m
};

Directions directionsOf(const SurfaceMesh& mesh, const SurfaceGeometry& geometry)
{
  Directions directions;
  directions.normal = volumeGradient(mesh);
  for (std::size_t i = 0; i < directions.normal.size(); ++i)
  {
    const double length = directions.normal[i].norm();
    const double area = std::max(length, SmallestArea * geometry.coVolumes()[i]);
    directions.area.push_back(area);
    directions.normal[i] /= length > 0.0 ? length : 1.0;
  }
  return directions;
}

/// The stiffness matrix of motions along the normals: l_ij n_i . n_j.
SparseMatrix alongNormals(
  const SparseMatrix& L, const std::vector<Vec3>& normals, const Execution& execution)
{
  SparseMatrix Ln = L;
  forEachIndex(execution, L.rows(),
    [&](Index row)
    {
      for (Index k = L.outerIndexPtr()[row]; k < L.outerIndexPtr()[row + 1]; ++k)
      {
        Ln.valuePtr()[k] *= normals[at(row)].dot(normals[at(L.innerIndexPtr()[k])]);
      }
    });
  return Ln;
}

} // namespace

SurfaceDiffusion::SurfaceDiffusion(double speed, double tolerance)
  : Speed(speed)
  , Tolerance(tolerance)
{
}

std::vector<Vec3> SurfaceDiffusion::velocity(const SurfaceMesh& mesh,
  const SurfaceGeometry& geometry, const std::vector<char>& isHeld, double timeStep,
  const Execution& execution)
{
  const Directions directions = directionsOf(mesh, geometry);
  std::vector<Vec3> velocity = directions.normal;
  const double root = std::sqrt(timeStep * this->Speed);
  this->Iterations = 0;
  if (root == 0.0)
  {
    std::fill(velocity.begin(), velocity.end(), Vec3::Zero());
    return velocity;
  }
  // y = sqrt(tau b) H makes the two halves alike.
  SparseMatrix L = geometry.volumes().stiffness();
  SparseMatrix Ln = alongNormals(L, directions.normal, execution);
  std::vector<double> diagonal(isHeld.size());
  std::vector<double> r(isHeld.size());
  forEachIndex(execution, mesh.vertexCount(),
    [&](Index i)
    {
      diagonal[at(i)] = directions.area[at(i)] / root;
      // mu h = -L F
      r[at(i)] = geometry.coVolumes()[at(i)] *
        geometry.curvatureVectors()[at(i)].dot(directions.normal[at(i)]);
    });
  const std::vector<double> zero(isHeld.size(), 0.0);
  std::vector<double> none(isHeld.size(), 0.0);
  eliminateKnown(isHeld, zero, Ln, r, execution);
  eliminateKnown(isHeld, zero, L, none, execution);
  std::vector<double> d;
  this->Iterations = DiffusionSystem(Ln, L, diagonal).solve(r, d, this->Tolerance, execution);
  forEachIndex(execution, mesh.vertexCount(),
    [&](Index i) { velocity[at(i)] *= isHeld[at(i)] ? 0.0 : d[at(i)] / timeStep; });
  return velocity;
}

} // namespace evolving
