// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Groups of strongly connected rows of a matrix: the coarse unknowns of algebraic multigrid.
 */

#ifndef EVOLVING_AGGREGATION_H
#define EVOLVING_AGGREGATION_H

#include "Algebra/SparseMatrix.h"
#include "Types.h"

#include <vector>

namespace evolving
{

struct Aggregation
{
  std::vector<Index> aggregateOfRow; ///< NoIndex for rows without strong connections
  Index count = 0;
};

/**
 * Disjoint aggregates, each a row with its strong neighbours where possible. Rows i, j are
 * strongly connected when |a_ij| >= threshold * sqrt(a_ii a_jj). Serial, in row order.
 */
Aggregation aggregate(const SparseMatrix& A, double threshold);

} // namespace evolving

#endif
