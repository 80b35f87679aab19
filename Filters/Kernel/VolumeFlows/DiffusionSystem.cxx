// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "VolumeFlows/DiffusionSystem.h"

#include "Algebra/Factorization.h"
#include "Algebra/Multigrid.h"
#include "Errors.h"
#include "ParallelLoops.h"

#include <memory>

namespace evolving
{

namespace
{

/// Multigrid takes 60 to 90; nearly degenerate faces defeat it.
constexpr int ManyCycles = 300;
/// A factorization takes about 20.
constexpr int ManyFactors = 500;

SparseMatrix withDiagonal(
  const SparseMatrix& A, const std::vector<double>& diagonal, const Execution& execution)
{
  SparseMatrix sum = A;
  forEachIndex(execution, A.rows(),
    [&](Index row)
    {
      for (Index k = A.outerIndexPtr()[row]; k < A.outerIndexPtr()[row + 1]; ++k)
      {
        sum.valuePtr()[k] += A.innerIndexPtr()[k] == row ? diagonal[at(row)] : 0.0;
      }
    });
  return sum;
}

void build(Factorization& inverse, const SparseMatrix& A, const Execution&)
{
  inverse.build(A);
}

void build(Multigrid& inverse, const SparseMatrix& A, const Execution& execution)
{
  inverse.build(A, execution);
}

/// Inverse: an approximate inverse of each of the two.
template <class Inverse>
class Halves : public Preconditioner
{
public:
  Halves(const SparseMatrix& first, const SparseMatrix& second, const Execution& execution)
  {
    build(this->First, first, execution);
    build(this->Second, second, execution);
  }

  void apply(
    const std::vector<double>& r, std::vector<double>& z, const Execution& execution) override
  {
    const auto middle = static_cast<std::ptrdiff_t>(r.size() / 2);
    z.resize(r.size());
    this->R.assign(r.begin(), r.begin() + middle);
    this->First.apply(this->R, this->Z, execution);
    std::copy(this->Z.begin(), this->Z.end(), z.begin());
    this->R.assign(r.begin() + middle, r.end());
    this->Second.apply(this->R, this->Z, execution);
    std::copy(this->Z.begin(), this->Z.end(), z.begin() + middle);
  }

private:
  Inverse First;
  Inverse Second;
  std::vector<double> R;
  std::vector<double> Z;
};

} // namespace

DiffusionSystem::DiffusionSystem(
  const SparseMatrix& first, const SparseMatrix& second, const std::vector<double>& diagonal)
  : Ln(first)
  , L(second)
  , D(diagonal)
{
}

void DiffusionSystem::apply(
  const std::vector<double>& x, std::vector<double>& y, const Execution& execution) const
{
  const std::size_t count = this->D.size();
  y.resize(2 * count);
  forEachIndex(execution, static_cast<std::int64_t>(count),
    [&](Index i)
    {
      const std::size_t j = at(i) + count;
      double first = -this->D[at(i)] * x[j];
      forEachEntry(
        this->Ln, i, [&](Index column, double value) { first += value * x[at(column)]; });
      double second = -this->D[at(i)] * x[at(i)];
      forEachEntry(
        this->L, i, [&](Index column, double value) { second -= value * x[at(column) + count]; });
      y[at(i)] = first;
      y[j] = second;
    });
}

int DiffusionSystem::solve(const std::vector<double>& r, std::vector<double>& d, double tolerance,
  const Execution& execution) const
{
  const SparseMatrix first = withDiagonal(this->Ln, this->D, execution);
  const SparseMatrix second = withDiagonal(this->L, this->D, execution);
  std::vector<double> b(r);
  b.resize(2 * r.size(), 0.0);
  std::vector<double> x;
  SolverLimits limits;
  limits.tolerance = tolerance;
  int iterations = 0;
  try
  {
    limits.maximumIterations = ManyCycles;
    Halves<Multigrid> inverse(first, second, execution);
    iterations = minimalResidual(*this, b, x, limits, inverse, execution);
  }
  catch (const SolverError&)
  {
    limits.maximumIterations = ManyFactors;
    Halves<Factorization> inverse(first, second, execution);
    iterations = minimalResidual(*this, b, x, limits, inverse, execution);
  }
  d.assign(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(r.size()));
  return iterations;
}

} // namespace evolving
