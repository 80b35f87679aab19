// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The volume-based tangential velocity (section 3.3.1): co-volumes grow asymptotically uniform,
 * or follow the curvature, while the surface moves.
 */

#ifndef EVOLVING_VOLUME_REDISTRIBUTION_H
#define EVOLVING_VOLUME_REDISTRIBUTION_H

#include "Algebra/PoissonSolver.h"
#include "Algebra/SolutionGuess.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Operators/SurfaceGeometry.h"
#include "Redistribution/RedistributionOptions.h"

#include <vector>

namespace evolving
{

/**
 * The right-hand side of -(L psi)_i = mu_i (v_N . h)_i - (mu_i / A) sum_j mu_j (v_N . h)_j +
 * omega (w_i - mu_i) (3.19), (4.19) with the signs of METHOD; sums, areas A and wanted co-volumes
 * w_i are those of the vertex's connected component, so that it sums to zero over each.
 * @param normalVelocity v_N = epsilon h + eta N, one per vertex
 * @param wanted w_i, see wantedCoVolumes()
 * @param rate omega
 * @param largestRate bound for |v_N . h|, 1/time: a co-volume cannot lose more than itself in a
 * step, but the h of a degenerate vertex knows no bounds
 */
std::vector<double> redistributionRightHandSide(const SurfaceGeometry& geometry,
  const std::vector<Vec3>& normalVelocity, const std::vector<double>& wanted, double rate,
  double largestRate, const Execution& execution);

/// Solves for psi from step to step.
class VolumeRedistribution
{
public:
  /// @param topology must outlive this object
  explicit VolumeRedistribution(const MeshTopology& topology);

  /**
   * v_T = grad psi, projected to the tangent planes. Zero Neumann condition at the boundary.
   * @param options volume and the curvature control are used, in absolute units
   * @param timeStep what v_T will be multiplied by
   * @throws SolverError, Cancelled
   */
  std::vector<Vec3> velocity(const SurfaceMesh& mesh, const SurfaceGeometry& geometry,
    const std::vector<Vec3>& normalVelocity, const RedistributionOptions& options, double timeStep,
    double tolerance, const Execution& execution);

  /// Makes psi zero, after a solve that failed.
  void forget();

  /// psi of the last velocity; 0 at the first vertex of every component.
  const std::vector<double>& potential() const { return this->Psi; }
  /// Of the last solve.
  int iterations() const { return this->Iterations; }

private:
  std::vector<char> IsPinned;
  PoissonSolver Solver;
  std::vector<double> Psi;
  SolutionGuess<double> Guess;
  int Iterations = 0;
};

} // namespace evolving

#endif
