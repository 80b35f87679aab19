// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Algebra/ConjugateGradients.h"

#include "Algebra/SolverFailure.h"
#include "Errors.h"
#include "ParallelLoops.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// The preconditioner "diagonal": z_i = r_i / a_ii.
template <class Value>
struct Jacobi
{
  const std::vector<double>& InverseDiagonal;

  double innerProduct(const std::vector<Value>&, double scaledNorm, const Execution&)
  {
    return scaledNorm;
  }
  Value z(const std::vector<Value>& r, Index i) const
  {
    return this->InverseDiagonal[at(i)] * r[at(i)];
  }
};

void applyTo(Preconditioner& inverse, const std::vector<double>& r, std::vector<double>& z,
  const Execution& execution)
{
  inverse.apply(r, z, execution);
}

/// Coordinate by coordinate.
void applyTo(Preconditioner& inverse, const std::vector<Vec3>& r, std::vector<Vec3>& z,
  const Execution& execution)
{
  z.resize(r.size());
  std::vector<double> rk(r.size());
  std::vector<double> zk;
  for (Index k = 0; k < 3; ++k)
  {
    std::transform(r.begin(), r.end(), rk.begin(), [k](const Vec3& v) { return v[k]; });
    inverse.apply(rk, zk, execution);
    for (std::size_t i = 0; i < z.size(); ++i)
    {
      z[i][k] = zk[i];
    }
  }
}

/// A preconditioner that needs its result stored.
template <class Value>
struct Stored
{
  Preconditioner& Inner;
  std::vector<Value> Z;

  double innerProduct(const std::vector<Value>& r, double, const Execution& execution)
  {
    applyTo(this->Inner, r, this->Z, execution);
    return sumEachIndex(execution, static_cast<std::int64_t>(r.size()),
      [&](Index i) { return dot(r[at(i)], this->Z[at(i)]); });
  }
  Value z(const std::vector<Value>&, Index i) const { return this->Z[at(i)]; }
};

/// Whether a residual has ceased to fall.
class Stagnation
{
public:
  explicit Stagnation(int patience)
    : Patience(patience)
  {
  }

  /// @param squaredNorm of the residual before an iteration
  bool isReached(int iteration, double squaredNorm)
  {
    if (iteration == 0 || squaredNorm <= 0.25 * this->Milestone)
    {
      this->Milestone = squaredNorm;
      this->Since = iteration;
    }
    return iteration - this->Since >= this->Patience;
  }

private:
  int Patience;
  double Milestone = 0.0;
  int Since = 0;
};

/// One run: the vectors of the method and its loop.
template <class Value, class Precondition>
class Iteration
{
public:
  Iteration(const SparseMatrix& matrix, const std::vector<double>& inverseDiagonal,
    Precondition precondition, const Execution& execution)
    : A(matrix)
    , InverseDiagonal(inverseDiagonal)
    , M(std::move(precondition))
    , Run(execution)
  {
  }

  int solve(const std::vector<Value>& b, std::vector<Value>& x, const SolverLimits& limits)
  {
    const double target = limits.tolerance * limits.tolerance * this->scaledNorm(b);
    if (target == 0.0)
    {
      std::fill(x.begin(), x.end(), zero<Value>());
      return 0;
    }
    double norm = this->start(b, x);
    double product = 0.0;
    Stagnation stagnation(limits.patience);
    for (int iteration = 0; norm > target; ++iteration)
    {
      this->Run.report(iteration / (iteration + 30.0));
      const double previous = product;
      product = this->M.innerProduct(this->R, norm, this->Run);
      this->updateDirection(iteration == 0 ? 0.0 : product / previous);
      const double curvature = multiplyAndDot(this->A, this->P, this->Q, this->Run);
      const double step = product / curvature;
      // NaN fails these comparisons too.
      if (iteration == limits.maximumIterations || stagnation.isReached(iteration, norm) ||
        !(curvature > 0.0 && product > 0.0) || !std::isfinite(step))
      {
        throwNotSolved(
          "linear", iteration, std::sqrt(norm / target) * limits.tolerance, limits.tolerance);
      }
      norm = this->advance(step, x);
      this->Iterations = iteration + 1;
    }
    if (!std::isfinite(norm))
    {
      throwNotSolved("linear", this->Iterations, norm, limits.tolerance);
    }
    return this->Iterations;
  }

private:
  double scaledNorm(const std::vector<Value>& v) const
  {
    return sumEachIndex(this->Run, this->count(),
      [&](Index i) { return this->InverseDiagonal[at(i)] * dot(v[at(i)], v[at(i)]); });
  }

  std::int64_t count() const { return this->A.rows(); }

  /// r = b - A x; returns its scaled norm. A guess that is worse than zero, or not finite after
  /// a solve that failed, is replaced by zero.
  double start(const std::vector<Value>& b, std::vector<Value>& x)
  {
    multiply(this->A, x, this->R, this->Run);
    forEachIndex(
      this->Run, this->count(), [&](Index i) { this->R[at(i)] = b[at(i)] - this->R[at(i)]; });
    double norm = this->scaledNorm(this->R);
    const double normOfZero = this->scaledNorm(b);
    if (!(norm <= normOfZero))
    {
      std::fill(x.begin(), x.end(), zero<Value>());
      this->R = b;
      norm = normOfZero;
    }
    this->P = this->R;
    return norm;
  }

  void updateDirection(double beta)
  {
    forEachIndex(this->Run, this->count(),
      [&](Index i)
      {
        const Value z = this->M.z(this->R, i);
        this->P[at(i)] = beta == 0.0 ? z : Value(z + beta * this->P[at(i)]);
      });
  }

  /// Moves x along p and updates r; returns its scaled norm.
  double advance(double step, std::vector<Value>& x)
  {
    return sumEachIndex(this->Run, this->count(),
      [&](Index i)
      {
        x[at(i)] += step * this->P[at(i)];
        Value& r = this->R[at(i)];
        r -= step * this->Q[at(i)];
        return this->InverseDiagonal[at(i)] * dot(r, r);
      });
  }

  const SparseMatrix& A;
  const std::vector<double>& InverseDiagonal;
  Precondition M;
  const Execution& Run;
  int Iterations = 0;
  std::vector<Value> R;
  std::vector<Value> P;
  std::vector<Value> Q;
};

template <class Value>
int solve(const SparseMatrix& A, const std::vector<Value>& b, std::vector<Value>& x,
  const SolverLimits& limits, const Execution& execution, Preconditioner* preconditioner)
{
  const std::vector<double> diagonal = inverseDiagonal(A, execution);
  if (preconditioner)
  {
    return Iteration<Value, Stored<Value>>(A, diagonal, { *preconditioner, {} }, execution)
      .solve(b, x, limits);
  }
  return Iteration<Value, Jacobi<Value>>(A, diagonal, { diagonal }, execution).solve(b, x, limits);
}

} // namespace

int conjugateGradients(const SparseMatrix& A, const std::vector<Vec3>& b, std::vector<Vec3>& x,
  const SolverLimits& limits, const Execution& execution, Preconditioner* preconditioner)
{
  return solve(A, b, x, limits, execution, preconditioner);
}

int conjugateGradients(const SparseMatrix& A, const std::vector<double>& b, std::vector<double>& x,
  const SolverLimits& limits, const Execution& execution, Preconditioner* preconditioner)
{
  return solve(A, b, x, limits, execution, preconditioner);
}

std::vector<double> approximateSolution(const SparseMatrix& A, const std::vector<double>& b,
  const SolverLimits& limits, const Execution& execution)
{
  std::vector<double> x(b.size(), 0.0);
  try
  {
    solve(A, b, x, limits, execution, nullptr);
  }
  catch (const SolverError&)
  {
    // The last iterate stays.
  }
  return x;
}

} // namespace evolving
