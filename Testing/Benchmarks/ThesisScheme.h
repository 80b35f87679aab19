// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The thesis's scheme for mean curvature flow as it says it, to compare with: sparse matrices put
 * together from triplets in every step, BiCGSTAB with a diagonal preconditioner, one thread.
 */

#ifndef BENCHMARK_THESIS_SCHEME_H
#define BENCHMARK_THESIS_SCHEME_H

#include "ThesisGeometry.h"
#include "ThesisTangential.h"

namespace benchmark
{

/// Of residuals, relative to the right-hand side. That of the positions is the positions
/// themselves, of which a step changes a small part.
struct ThesisTolerances
{
  double positions = 1e-13;
  double potential = 1e-10;
};

class ThesisScheme
{
public:
  /// @param start closed, of triangles
  ThesisScheme(const evolving::SurfaceMesh& start, const ThesisTolerances& tolerances);

  /// From now on with the tangential velocity of section 4.4.
  void redistribute(const TangentialForm& form, double omega);

  /// F^t becomes F^(t + tau). Leaves the program when a system is not solved.
  void step(double tau);

  const Eigen::MatrixX3d& positions() const { return this->F; }
  /// Of the start of the last step.
  const Eigen::VectorXd& coVolumes() const { return this->Geometry.mu; }
  /// Of all solves so far: three coordinates a step, one potential a step.
  long long coordinateIterations() const { return this->CoordinateIterations; }
  long long potentialIterations() const { return this->PotentialIterations; }

private:
  void solvePotential();
  void solvePositions(double tau, const Eigen::MatrixX3d& b);

  Rings Neighbours;
  ThesisTolerances Tolerances;
  bool Redistributes = false;
  TangentialForm Form = RightForm;
  double Omega = 0.0;
  Eigen::MatrixX3d F;
  Eigen::VectorXd Psi;
  ThesisGeometry Geometry;
  long long CoordinateIterations = 0;
  long long PotentialIterations = 0;
};

} // namespace benchmark

#endif
