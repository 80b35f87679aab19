// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The conjugate gradient method for symmetric positive definite systems.
 */

#ifndef EVOLVING_CONJUGATE_GRADIENTS_H
#define EVOLVING_CONJUGATE_GRADIENTS_H

#include "Algebra/SparseMatrix.h"
#include "Execution.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// An approximate inverse of a matrix: symmetric, positive definite and linear.
class Preconditioner
{
public:
  virtual ~Preconditioner() = default;
  /// z = approximate inverse applied to r.
  virtual void apply(
    const std::vector<double>& r, std::vector<double>& z, const Execution& execution) = 0;
};

/// When the iteration ends.
struct SolverLimits
{
  double tolerance = 1e-10; ///< of the residual, relative to the right-hand side
  int maximumIterations = 10000;
  /// So many iterations must halve the residual; where they do not, rounding keeps it from the
  /// tolerance. Without a good preconditioner a grid of a million nodes takes about a hundred.
  int patience = 1000;
};

/**
 * Solves A x = b from the guess in x. For points (Value = Vec3) the three coordinates are one
 * system with one step length, so that A is read once per iteration.
 *
 * The residual is measured as the root of the sum of r_i^2 / a_ii: rows scaled up by tiny
 * epsilon_i in (4.16) then weigh no more than the others.
 * @param preconditioner null for the diagonal (Jacobi)
 * @return the number of iterations
 * @throws SolverError when A is not positive definite or the residual stays above the tolerance
 * @throws Cancelled
 */
int conjugateGradients(const SparseMatrix& A, const std::vector<Vec3>& b, std::vector<Vec3>& x,
  const SolverLimits& limits, const Execution& execution, Preconditioner* preconditioner = nullptr);
int conjugateGradients(const SparseMatrix& A, const std::vector<double>& b, std::vector<double>& x,
  const SolverLimits& limits, const Execution& execution, Preconditioner* preconditioner = nullptr);

/**
 * The solution of A x = b from zero; where the residual stays above the tolerance what has been
 * reached, which is as good as any for a step that is followed by others.
 * @throws Cancelled
 */
std::vector<double> approximateSolution(const SparseMatrix& A, const std::vector<double>& b,
  const SolverLimits& limits, const Execution& execution);

} // namespace evolving

#endif
