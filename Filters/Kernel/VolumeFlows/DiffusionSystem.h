// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The linear system of a step of surface diffusion.
 */

#ifndef EVOLVING_DIFFUSION_SYSTEM_H
#define EVOLVING_DIFFUSION_SYSTEM_H

#include "Algebra/MinimalResidual.h"
#include "Algebra/SparseMatrix.h"
#include "Execution.h"

#include <vector>

namespace evolving
{

/**
 *   ( Ln  -D ) (d)   (r)
 *   ( -D  -L ) (y) = (0)
 *
 * with stiffness matrices Ln and L, positive semi-definite, and a positive diagonal D: two Poisson
 * problems of which each is the other's right-hand side. Preconditioned by Ln + D and L + D, which
 * have the eigenvalues of the whole, for Ln = L, within [-1, -1/sqrt 2] and [1/sqrt 2, 1] whatever
 * the mesh and the step: (a, D) of one mode give +-sqrt(a^2 + D^2) / (a + D). So the iterations
 * hardly grow with either.
 */
class DiffusionSystem : public SymmetricOperator
{
public:
  /**
   * @param first,second Ln and L, of equal size, with stored diagonals; must outlive this object
   * @param diagonal D
   */
  DiffusionSystem(
    const SparseMatrix& first, const SparseMatrix& second, const std::vector<double>& diagonal);

  /**
   * @param r one per row of Ln
   * @param[out] d the solution's first half
   * @return the number of iterations
   * @throws SolverError, Cancelled
   */
  int solve(const std::vector<double>& r, std::vector<double>& d, double tolerance,
    const Execution& execution) const;

  void apply(const std::vector<double>& x, std::vector<double>& y,
    const Execution& execution) const override;

private:
  const SparseMatrix& Ln;
  const SparseMatrix& L;
  const std::vector<double>& D;
};

} // namespace evolving

#endif
