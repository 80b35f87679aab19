// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Poisson problems on a surface that changes little from one solve to the next.
 */

#ifndef EVOLVING_POISSON_SOLVER_H
#define EVOLVING_POISSON_SOLVER_H

#include "Algebra/ConjugateGradients.h"
#include "Algebra/Multigrid.h"
#include "Algebra/SparseMatrix.h"
#include "Execution.h"

#include <vector>

namespace evolving
{

/**
 * Solves L psi = b with psi = 0 in pinned rows by conjugate gradients. The preconditioner was
 * built from an earlier matrix and is kept until it costs twice the iterations it did when new:
 * building one costs as much as many iterations, and a step changes the matrix little.
 */
class PoissonSolver
{
public:
  /**
   * @param L symmetric, positive definite once the pinned rows are removed; its pattern must not
   * change between calls
   * @param isPinned one flag per row; rows without a positive diagonal, those of vertices whose
   * faces have shrunk to points, are pinned too
   * @param[in,out] psi the guess (the last solution), then the solution
   * @return the number of iterations
   * @throws SolverError, Cancelled
   */
  int solve(const SparseMatrix& L, const std::vector<char>& isPinned, std::vector<double> b,
    std::vector<double>& psi, const SolverLimits& limits, const Execution& execution);

private:
  int solveReduced(const std::vector<double>& b, std::vector<double>& psi,
    const SolverLimits& limits, const Execution& execution);
  void rebuild(const Execution& execution);

  SparseMatrix A; ///< L without the pinned rows and columns
  Multigrid Inverse;
  bool IsBuilt = false;
  bool IsNew = false;
  int IterationsWhenNew = 0;
};

} // namespace evolving

#endif
