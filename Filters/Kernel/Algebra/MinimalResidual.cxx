// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Algebra/MinimalResidual.h"

#include "Algebra/SolverFailure.h"
#include "ParallelLoops.h"

#include <cmath>
#include <utility>

namespace evolving
{

namespace
{

using Vector = std::vector<double>;

/// A plane rotation that turns (a, b) to (length, 0).
struct Rotation
{
  double c = 1.0;
  double s = 0.0;
};

/// The Lanczos vectors, orthogonal in the preconditioner's inner product.
class LanczosBasis
{
public:
  LanczosBasis(const SymmetricOperator& matrix, const Vector& b, Preconditioner& inverse,
    const Execution& execution)
    : A(matrix)
    , Inverse(inverse)
    , Run(execution)
    , V(b)
    , Before(b.size(), 0.0)
  {
    this->Inverse.apply(this->V, this->Z, this->Run);
    this->Beta = this->norm();
  }

  /// Of the newest vector before it is scaled; NaN where the preconditioner is not definite.
  double beta() const { return this->Beta; }
  double alpha() const { return this->Alpha; }
  const Vector& direction() const { return this->Z; } ///< of length one

  /// Makes the newest vector one of length one.
  void scale()
  {
    forEachIndex(this->Run, this->count(),
      [this](Index i)
      {
        this->V[at(i)] /= this->Beta;
        this->Z[at(i)] /= this->Beta;
      });
  }

  /// The next one, not scaled.
  void advance()
  {
    this->A.apply(this->Z, this->Next, this->Run);
    this->Alpha = sumEachIndex(
      this->Run, this->count(), [this](Index i) { return this->Next[at(i)] * this->Z[at(i)]; });
    forEachIndex(this->Run, this->count(),
      [this](Index i)
      { this->Next[at(i)] -= this->Alpha * this->V[at(i)] + this->Beta * this->Before[at(i)]; });
    std::swap(this->Before, this->V);
    std::swap(this->V, this->Next);
    this->Inverse.apply(this->V, this->NextZ, this->Run);
    std::swap(this->Z, this->NextZ);
    this->Beta = this->norm();
  }

  std::int64_t count() const { return static_cast<std::int64_t>(this->V.size()); }

private:
  double norm() const
  {
    return std::sqrt(sumEachIndex(
      this->Run, this->count(), [this](Index i) { return this->V[at(i)] * this->Z[at(i)]; }));
  }

  const SymmetricOperator& A;
  Preconditioner& Inverse;
  const Execution& Run;
  Vector V;
  Vector Before;
  Vector Next;
  Vector Z; ///< the preconditioner applied to V
  Vector NextZ;
  double Alpha = 0.0;
  double Beta = 0.0;
};

/// What has been reached, and the directions in which it changes.
class Iterate
{
public:
  Iterate(Vector& x, const Execution& execution)
    : X(x)
    , Run(execution)
    , Last(x.size(), 0.0)
    , BeforeLast(x.size(), 0.0)
  {
  }

  /// x += length * w, r0 w = z - r1 (the last w) - r2 (the one before).
  void advance(const Vector& z, double r0, double r1, double r2, double length)
  {
    forEachIndex(this->Run, static_cast<std::int64_t>(this->X.size()),
      [&](Index i)
      {
        const double w = (z[at(i)] - r1 * this->Last[at(i)] - r2 * this->BeforeLast[at(i)]) / r0;
        this->BeforeLast[at(i)] = w;
        this->X[at(i)] += length * w;
      });
    std::swap(this->Last, this->BeforeLast);
  }

private:
  Vector& X;
  const Execution& Run;
  Vector Last;
  Vector BeforeLast;
};

} // namespace

int minimalResidual(const SymmetricOperator& A, const std::vector<double>& b,
  std::vector<double>& x, const SolverLimits& limits, Preconditioner& preconditioner,
  const Execution& execution)
{
  x.assign(b.size(), 0.0);
  LanczosBasis basis(A, b, preconditioner, execution);
  const double target = limits.tolerance * basis.beta();
  double residual = basis.beta();
  Iterate iterate(x, execution);
  Rotation last;
  Rotation beforeLast;
  int iteration = 0;
  while (std::abs(residual) > target)
  {
    execution.report(iteration / (iteration + 30.0));
    const double beta = basis.beta();
    basis.scale();
    const Vector z = basis.direction();
    basis.advance();
    // The next column of the tridiagonal matrix, turned by the last two rotations and a new one.
    const double turned = last.c * basis.alpha() - beforeLast.c * last.s * beta;
    const double r0 = std::hypot(turned, basis.beta());
    const double r1 = last.s * basis.alpha() + beforeLast.c * last.c * beta;
    const double r2 = beforeLast.s * beta;
    beforeLast = std::exchange(last, { turned / r0, basis.beta() / r0 });
    iterate.advance(z, r0, r1, r2, last.c * residual);
    residual *= -last.s;
    ++iteration;
    // NaN fails this comparison, too.
    if (!(std::abs(residual) <= target) &&
      (iteration >= limits.maximumIterations || !std::isfinite(residual)))
    {
      throwNotSolved(
        "coupled", iteration, std::abs(residual) / target * limits.tolerance, limits.tolerance);
    }
  }
  if (!std::isfinite(residual))
  {
    throwNotSolved("coupled", iteration, residual, limits.tolerance);
  }
  return iteration;
}

} // namespace evolving
