// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * One semi-implicit step of the evolution (4.16).
 */

#ifndef EVOLVING_SEMI_IMPLICIT_STEP_H
#define EVOLVING_SEMI_IMPLICIT_STEP_H

#include "Algebra/SolutionGuess.h"
#include "Algebra/SparseMatrix.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Operators/SurfaceGeometry.h"

#include <vector>

namespace evolving
{

/// What moves the vertices in a step; one entry per vertex.
struct StepInput
{
  const std::vector<double>& epsilon;
  const std::vector<Vec3>& explicitVelocity;  ///< eta N + v_T
  const std::vector<char>& isKnown;           ///< vertices whose displacement is given
  const std::vector<Vec3>& knownDisplacement; ///< read at those
  double timeStep = 0.0;
  const std::vector<double>* stiffness = nullptr; ///< k below; null for 0
};

/**
 * Solves (I + tau diag(epsilon / mu) L) F^(t+tau) = F^t + tau (eta N + v_T) (4.16), with L, mu
 * and N of time t. Row i times mu_i / epsilon_i makes it symmetric; the unknown is the
 * displacement D = F^(t+tau) - F^t, so that a surface far from the origin loses nothing:
 *
 *   (diag(mu / epsilon) + tau L) D = tau (-L F^t + diag(mu / epsilon)(eta N + v_T))
 *
 * Where eta falls along the normal at a rate k tau that is not small, as at an edge of an image, it
 * is linearized: (1 + tau k_i) instead of 1 on the left, so that steps of any length end where
 * the right-hand side is 0, instead of leaping over that.
 *
 * Rows with epsilon_i below 1e-12 of the largest move by tau (eta N + v_T) / (1 + tau k); they and
 * the rows of vertices with a given displacement are eliminated. Boundary vertices without one have
 * the natural boundary condition.
 */
class SemiImplicitStep
{
public:
  /**
   * @return the displacement of every vertex
   * @param tolerance of the linear solver
   * @throws SolverError, Cancelled
   */
  const std::vector<Vec3>& displacement(const SurfaceGeometry& geometry, const StepInput& input,
    double tolerance, const Execution& execution);

  /**
   * What forces add to the last displacement: A D = force with the same A, and D = 0 where it is
   * known.
   * @throws SolverError, Cancelled
   */
  std::vector<Vec3> response(
    const std::vector<Vec3>& force, double tolerance, const Execution& execution);

  /// Of the last displacement and its response.
  int iterations() const { return this->Iterations; }

private:
  void guessDisplacement(const Execution& execution);
  void markKnown(const SurfaceGeometry& geometry, const StepInput& input);
  void assemble(
    const SurfaceGeometry& geometry, const StepInput& input, const Execution& execution);

  SparseMatrix A;
  std::vector<Vec3> B;
  std::vector<char> IsKnown;
  std::vector<Vec3> Known;
  std::vector<Vec3> Displacement;
  SolutionGuess<Vec3> Guess;
  int Iterations = 0;
};

} // namespace evolving

#endif
