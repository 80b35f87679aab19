// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Algebra/PoissonSolver.h"

#include "Algebra/Factorization.h"
#include "Errors.h"
#include "ParallelLoops.h"

#include <algorithm>

namespace evolving
{

namespace
{

/// What a good hierarchy can do: it takes 20 to 30 iterations.
SolverLimits limitsForCycles(const SolverLimits& limits)
{
  SolverLimits least = limits;
  least.maximumIterations = std::min(limits.maximumIterations, 100);
  return least;
}

} // namespace

int PoissonSolver::solve(const SparseMatrix& L, const std::vector<char>& isPinned,
  std::vector<double> b, std::vector<double>& psi, const SolverLimits& limits,
  const Execution& execution)
{
  const std::vector<double> zero(b.size(), 0.0);
  std::vector<char> isKnown(b.size());
  forEachIndex(execution, rowCount(L),
    [&](Index row)
    {
      isKnown[at(row)] = isPinned[at(row)] || !(diagonalEntry(L, row) > 0.0);
      psi[at(row)] = isKnown[at(row)] ? 0.0 : psi[at(row)];
    });
  this->A = L;
  eliminateKnown(isKnown, zero, this->A, b, execution);
  return this->solveReduced(b, psi, limits, execution);
}

int PoissonSolver::solveReduced(const std::vector<double>& b, std::vector<double>& psi,
  const SolverLimits& limits, const Execution& execution)
{
  try
  {
    if (!this->IsBuilt)
    {
      this->rebuild(execution);
    }
    const int iterations =
      conjugateGradients(this->A, b, psi, limitsForCycles(limits), execution, &this->Inverse);
    this->IterationsWhenNew = this->IsNew ? iterations : this->IterationsWhenNew;
    this->IsNew = false;
    this->IsBuilt = iterations <= 2 * this->IterationsWhenNew + 5;
    return iterations;
  }
  catch (const SolverError&)
  {
    this->IsBuilt = false;
    return solveByFactorization(this->A, b, psi, limits, execution);
  }
}

void PoissonSolver::rebuild(const Execution& execution)
{
  this->Inverse.build(this->A, execution);
  this->IsBuilt = true;
  this->IsNew = true;
}

} // namespace evolving
