// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * An algebraic multigrid preconditioner for Laplacians on surfaces.
 */

#ifndef EVOLVING_MULTIGRID_H
#define EVOLVING_MULTIGRID_H

#include "Algebra/ConjugateGradients.h"
#include "Algebra/Factorization.h"
#include "Algebra/SparseMatrix.h"
#include "Execution.h"

#include <vector>

namespace evolving
{

/**
 * One V-cycle of smoothed aggregation (Vanek, Mandel, Brezina, *Algebraic multigrid by smoothed
 * aggregation for second and fourth order elliptic problems*, 1996): neighbouring rows are
 * merged into aggregates level by level until a Cholesky factorization is cheap; a matrix that
 * small to begin with is simply factorized.
 *
 * The smoother divides by the sums of the rows' absolute values (l1-Jacobi; Baker, Falgout,
 * Kolev, Yang, *Multigrid smoothers for ultraparallel computing*, 2011). It converges for every
 * positive definite matrix, also with the negative weights of obtuse angles.
 */
class Multigrid : public Preconditioner
{
public:
  Multigrid();
  ~Multigrid() override;

  /**
   * Analyses a symmetric positive definite matrix.
   * @throws SolverError when the coarsest matrix is not positive definite
   * @throws Cancelled
   */
  void build(const SparseMatrix& A, const Execution& execution);

  void apply(
    const std::vector<double>& r, std::vector<double>& z, const Execution& execution) override;

  /// The number of matrices in the hierarchy; 1 when the matrix itself was factorized.
  int levelCount() const;

private:
  struct Level;
  void cycle(std::size_t level, const Execution& execution);

  std::vector<Level> Levels;
  Factorization Coarsest;
};

} // namespace evolving

#endif
