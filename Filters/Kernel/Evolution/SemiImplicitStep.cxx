// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SemiImplicitStep.h"

#include "Algebra/ConjugateGradients.h"
#include "Algebra/Factorization.h"
#include "Errors.h"
#include "ParallelLoops.h"

#include <algorithm>

namespace evolving
{

namespace
{

/// epsilon_i / max epsilon below which a row counts as one without curvature motion.
constexpr double SmallestEpsilon = 1e-12;

/// 1 + tau k.
double damping(const StepInput& input, Index vertex)
{
  return input.stiffness ? 1.0 + input.timeStep * (*input.stiffness)[at(vertex)] : 1.0;
}

/// Good elements take 30 to 40 iterations.
int solve(const SparseMatrix& A, const std::vector<Vec3>& b, std::vector<Vec3>& x, double tolerance,
  const Execution& execution)
{
  SolverLimits limits;
  limits.tolerance = tolerance;
  SolverLimits few = limits;
  few.maximumIterations = 500;
  try
  {
    return conjugateGradients(A, b, x, few, execution);
  }
  catch (const SolverError&)
  {
    return solveByFactorization(A, b, x, limits, execution);
  }
}

} // namespace

const std::vector<Vec3>& SemiImplicitStep::displacement(const SurfaceGeometry& geometry,
  const StepInput& input, double tolerance, const Execution& execution)
{
  this->markKnown(geometry, input);
  this->assemble(geometry, input, execution);
  eliminateKnown(this->IsKnown, this->Known, this->A, this->B, execution);
  this->guessDisplacement(execution);
  this->Iterations = solve(this->A, this->B, this->Displacement, tolerance, execution);
  return this->Displacement;
}

std::vector<Vec3> SemiImplicitStep::response(
  const std::vector<Vec3>& force, double tolerance, const Execution& execution)
{
  std::vector<Vec3> b(force.size());
  forEachIndex(execution, this->A.rows(),
    [&](Index i) { b[at(i)] = this->IsKnown[at(i)] ? Vec3(Vec3::Zero()) : force[at(i)]; });
  std::vector<Vec3> response(force.size(), Vec3::Zero());
  this->Iterations += solve(this->A, b, response, tolerance, execution);
  return response;
}

void SemiImplicitStep::guessDisplacement(const Execution& execution)
{
  this->Displacement.resize(this->B.size(), Vec3::Zero());
  this->Guess.extrapolate(this->Displacement, execution);
  forEachIndex(execution, this->A.rows(),
    [this](Index i)
    {
      if (this->IsKnown[at(i)])
      {
        this->Displacement[at(i)] = this->Known[at(i)];
      }
    });
}

void SemiImplicitStep::markKnown(const SurfaceGeometry& geometry, const StepInput& input)
{
  const double largest = *std::max_element(input.epsilon.begin(), input.epsilon.end());
  this->IsKnown.resize(input.epsilon.size());
  this->Known.resize(input.epsilon.size());
  for (Index i = 0; i < geometry.topology().vertexCount(); ++i)
  {
    const bool isGiven = input.isKnown[at(i)] != 0;
    this->IsKnown[at(i)] = isGiven || input.epsilon[at(i)] <= SmallestEpsilon * largest;
    this->Known[at(i)] = isGiven
      ? input.knownDisplacement[at(i)]
      : Vec3(input.timeStep / damping(input, i) * input.explicitVelocity[at(i)]);
  }
}

void SemiImplicitStep::assemble(
  const SurfaceGeometry& geometry, const StepInput& input, const Execution& execution)
{
  const SparseMatrix& L = geometry.volumes().stiffness();
  const double tau = input.timeStep;
  if (this->A.nonZeros() != L.nonZeros())
  {
    this->A = L;
  }
  this->B.resize(at(rowCount(L)));
  forEachIndex(execution, L.rows(),
    [&](Index row)
    {
      if (this->IsKnown[at(row)])
      {
        return; // replaced by eliminateKnown()
      }
      const double mu = geometry.coVolumes()[at(row)];
      const double weight = mu / input.epsilon[at(row)];
      const double diagonal = weight * damping(input, row);
      for (Index k = L.outerIndexPtr()[row]; k < L.outerIndexPtr()[row + 1]; ++k)
      {
        this->A.valuePtr()[k] =
          tau * L.valuePtr()[k] + (L.innerIndexPtr()[k] == row ? diagonal : 0.0);
      }
      // -L F = mu h
      this->B[at(row)] = tau *
        (mu * geometry.curvatureVectors()[at(row)] + weight * input.explicitVelocity[at(row)]);
    });
}

} // namespace evolving
