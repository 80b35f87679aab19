// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The minimal residual method for symmetric systems that are not definite.
 */

#ifndef EVOLVING_MINIMAL_RESIDUAL_H
#define EVOLVING_MINIMAL_RESIDUAL_H

#include "Algebra/ConjugateGradients.h"
#include "Execution.h"

#include <vector>

namespace evolving
{

/// A symmetric matrix by what it does.
class SymmetricOperator
{
public:
  virtual ~SymmetricOperator() = default;
  /// y = A x.
  virtual void apply(
    const std::vector<double>& x, std::vector<double>& y, const Execution& execution) const = 0;
};

/**
 * Solves A x = b from zero (Paige, Saunders, *Solution of sparse indefinite systems of linear
 * equations*, 1975). The residual is measured as the root of r . z, z the preconditioned r.
 * @param preconditioner symmetric and positive definite; good when the eigenvalues of its product
 * with A lie in two short intervals, one at either side of zero
 * @return the number of iterations
 * @throws SolverError when the residual stays above the tolerance
 * @throws Cancelled
 */
int minimalResidual(const SymmetricOperator& A, const std::vector<double>& b,
  std::vector<double>& x, const SolverLimits& limits, Preconditioner& preconditioner,
  const Execution& execution);

} // namespace evolving

#endif
