// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The Cholesky factorization of a sparse matrix, as a preconditioner.
 */

#ifndef EVOLVING_FACTORIZATION_H
#define EVOLVING_FACTORIZATION_H

#include "Algebra/ConjugateGradients.h"
#include "Algebra/SparseMatrix.h"

#include <memory>
#include <vector>

namespace evolving
{

/// The inverse of a matrix, but for rounding: a solve needs one iteration, or a few where the
/// matrix is nearly singular.
class Factorization : public Preconditioner
{
public:
  Factorization();
  ~Factorization() override;

  /**
   * Factors a symmetric positive definite matrix.
   * @throws SolverError when it is not positive definite
   */
  void build(const SparseMatrix& A);

  void apply(
    const std::vector<double>& r, std::vector<double>& z, const Execution& execution) override;

private:
  struct Factors;
  std::unique_ptr<Factors> LDLT;
};

/**
 * Solves A x = b where conjugate gradients alone take too long: nearly degenerate faces, whose
 * weights are huge, defeat other preconditioners, but not a factorization.
 * @param limits the tolerance, and what is left to the plain method where A is not definite
 * @return the number of iterations
 * @throws SolverError, Cancelled
 */
template <class Value>
int solveByFactorization(const SparseMatrix& A, const std::vector<Value>& b, std::vector<Value>& x,
  const SolverLimits& limits, const Execution& execution);

} // namespace evolving

#endif
