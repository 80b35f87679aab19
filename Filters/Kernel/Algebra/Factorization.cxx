// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Algebra/Factorization.h"

#include "Errors.h"

#include <Eigen/SparseCholesky>

namespace evolving
{

struct Factorization::Factors
{
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double, Eigen::ColMajor, Index>> Solver;
};

Factorization::Factorization() = default;
Factorization::~Factorization() = default;

void Factorization::build(const SparseMatrix& A)
{
  this->LDLT = std::make_unique<Factors>();
  this->LDLT->Solver.compute(A);
  if (this->LDLT->Solver.info() != Eigen::Success ||
    !(this->LDLT->Solver.vectorD().minCoeff() > 0.0))
  {
    throw SolverError("The matrix of a linear system is not positive definite, expected a surface "
                      "with faces of positive area; repair the mesh.");
  }
}

void Factorization::apply(const std::vector<double>& r, std::vector<double>& z, const Execution&)
{
  const auto size = static_cast<Eigen::Index>(r.size());
  z.resize(r.size());
  Eigen::Map<Eigen::VectorXd>(z.data(), size) =
    this->LDLT->Solver.solve(Eigen::Map<const Eigen::VectorXd>(r.data(), size));
}

namespace
{

/// Iterations that take back the rounding of a factorization.
SolverLimits limitsForFactors(double tolerance)
{
  SolverLimits limits;
  limits.tolerance = tolerance;
  limits.maximumIterations = 50;
  limits.patience = 10;
  return limits;
}

} // namespace

template <class Value>
int solveByFactorization(const SparseMatrix& A, const std::vector<Value>& b, std::vector<Value>& x,
  const SolverLimits& limits, const Execution& execution)
{
  x.assign(b.size(), zero<Value>());
  try
  {
    execution.report(0.0);
    Factorization inverse;
    inverse.build(A);
    return conjugateGradients(A, b, x, limitsForFactors(limits.tolerance), execution, &inverse);
  }
  catch (const SolverError&)
  {
    x.assign(b.size(), zero<Value>());
    return conjugateGradients(A, b, x, limits, execution);
  }
}

template int solveByFactorization(const SparseMatrix&, const std::vector<double>&,
  std::vector<double>&, const SolverLimits&, const Execution&);
template int solveByFactorization(const SparseMatrix&, const std::vector<Vec3>&, std::vector<Vec3>&,
  const SolverLimits&, const Execution&);

} // namespace evolving
