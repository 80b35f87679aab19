// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Algebra/Multigrid.h"

#include "Algebra/Aggregation.h"
#include "ParallelLoops.h"

namespace evolving
{

namespace
{

/// Up to here a factorization is as cheap as a cycle over more levels.
constexpr Index LargestFactorized = 3000;
/// Of strong connections; the usual value.
constexpr double StrengthThreshold = 0.08;
/// Damping of l1-Jacobi, whose iteration matrix has eigenvalues in (0, 1]: the usual 4/3.
constexpr double Damping = 4.0 / 3.0;

/// Damping / sum_j |a_ij|.
std::vector<double> smootherOf(const SparseMatrix& A, const Execution& execution)
{
  std::vector<double> smoother(at(rowCount(A)));
  forEachIndex(execution, A.rows(),
    [&](Index row)
    {
      double sum = 0.0;
      forEachEntry(A, row, [&](Index, double value) { sum += std::abs(value); });
      smoother[at(row)] = sum > 0.0 ? Damping / sum : 0.0;
    });
  return smoother;
}

/// One column of ones per aggregate.
SparseMatrix tentativeProlongation(const Aggregation& aggregation)
{
  const std::vector<Index>& of = aggregation.aggregateOfRow;
  SparseMatrix P(static_cast<Index>(of.size()), aggregation.count);
  P.reserve(Eigen::VectorXi::Ones(P.rows()));
  for (Index row = 0; row < rowCount(P); ++row)
  {
    if (of[at(row)] != NoIndex)
    {
      P.insert(row, of[at(row)]) = 1.0;
    }
  }
  P.makeCompressed();
  return P;
}

} // namespace

struct Multigrid::Level
{
  SparseMatrix A;
  SparseMatrix Prolongation; ///< from the next level; empty on the coarsest
  SparseMatrix Restriction;
  std::vector<double> Smoother;
  std::vector<double> R; ///< right-hand side of the current cycle
  std::vector<double> Z; ///< its approximate solution
  std::vector<double> Work;

  void buildTransfer(const Execution& execution)
  {
    this->Smoother = smootherOf(this->A, execution);
    const SparseMatrix tentative = tentativeProlongation(aggregate(this->A, StrengthThreshold));
    const Eigen::Map<const Eigen::VectorXd> smoother(this->Smoother.data(), this->A.rows());
    const SparseMatrix correction = this->A * tentative;
    this->Prolongation = tentative - SparseMatrix(smoother.asDiagonal() * correction);
    this->Restriction = this->Prolongation.transpose();
  }

  SparseMatrix coarseMatrix() const
  {
    const SparseMatrix right = this->A * this->Prolongation;
    return this->Restriction * right;
  }

  /// z += smoother (r - A z)
  void smooth(const Execution& execution)
  {
    multiply(this->A, this->Z, this->Work, execution);
    forEachIndex(execution, this->A.rows(),
      [this](Index i)
      { this->Z[at(i)] += this->Smoother[at(i)] * (this->R[at(i)] - this->Work[at(i)]); });
  }

  void smoothFromZero(const Execution& execution)
  {
    this->Z.resize(this->R.size());
    forEachIndex(execution, this->A.rows(),
      [this](Index i) { this->Z[at(i)] = this->Smoother[at(i)] * this->R[at(i)]; });
  }

  void restrictResidual(std::vector<double>& coarse, const Execution& execution)
  {
    multiply(this->A, this->Z, this->Work, execution);
    forEachIndex(execution, this->A.rows(),
      [this](Index i) { this->Work[at(i)] = this->R[at(i)] - this->Work[at(i)]; });
    multiply(this->Restriction, this->Work, coarse, execution);
  }

  void addCorrection(const std::vector<double>& coarse, const Execution& execution)
  {
    multiply(this->Prolongation, coarse, this->Work, execution);
    forEachIndex(
      execution, this->A.rows(), [this](Index i) { this->Z[at(i)] += this->Work[at(i)]; });
  }
};

Multigrid::Multigrid() = default;
Multigrid::~Multigrid() = default;

int Multigrid::levelCount() const
{
  return static_cast<int>(this->Levels.size());
}

void Multigrid::build(const SparseMatrix& A, const Execution& execution)
{
  this->Levels.clear();
  this->Levels.emplace_back().A = A;
  while (this->Levels.back().A.rows() > LargestFactorized)
  {
    execution.report(0.0);
    Level& fine = this->Levels.back();
    fine.buildTransfer(execution);
    SparseMatrix coarse = fine.coarseMatrix();
    if (coarse.rows() == 0 || 2 * coarse.rows() > fine.A.rows())
    {
      break; // not getting coarser: factorize what there is
    }
    this->Levels.emplace_back().A = std::move(coarse);
  }
  this->Coarsest.build(this->Levels.back().A);
}

void Multigrid::apply(
  const std::vector<double>& r, std::vector<double>& z, const Execution& execution)
{
  this->Levels.front().R = r;
  this->cycle(0, execution);
  z = this->Levels.front().Z;
}

void Multigrid::cycle(std::size_t level, const Execution& execution)
{
  Level& fine = this->Levels[level];
  if (level + 1 == this->Levels.size())
  {
    this->Coarsest.apply(fine.R, fine.Z, execution);
    return;
  }
  Level& coarse = this->Levels[level + 1];
  fine.smoothFromZero(execution);
  fine.restrictResidual(coarse.R, execution);
  this->cycle(level + 1, execution);
  fine.addCorrection(coarse.Z, execution);
  fine.smooth(execution);
}

} // namespace evolving
