// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which linear algebra fits the two systems of a step, the positions' (4.16) and the potential's
 * (4.24): conjugate gradients with several preconditioners, and a Cholesky factorization.
 */

#include "Arguments.h"
#include "BumpySphere.h"
#include "Report.h"
#include "StepSystems.h"
#include "Timing.h"

#include "Algebra/ConjugateGradients.h"
#include "Algebra/Multigrid.h"
#include "Algebra/PoissonSolver.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

#include <cstdlib>
#include <iostream>

using namespace benchmark;
using evolving::Multigrid;
using evolving::SolverLimits;
using evolving::Vec3;

namespace
{

using ColumnMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
using Cholesky = Eigen::SimplicialLDLT<ColumnMatrix>;
using WithIncompleteCholesky =
  Eigen::ConjugateGradient<ColumnMatrix, Eigen::Lower, Eigen::IncompleteCholesky<double>>;

const evolving::Execution OneThread;
const SolverLimits PositionLimits{ 1e-10, 10000 };
const SolverLimits PotentialLimits{ 1e-8, 10000 };

template <class Solver>
void requireSolved(const Solver& solver)
{
  if (solver.info() != Eigen::Success)
  {
    std::cerr << "A system was not solved; expected a positive definite matrix.\n";
    std::exit(1);
  }
}

/// The coordinates as right-hand sides of their own.
std::vector<std::vector<double>> coordinatesOf(const std::vector<Vec3>& b)
{
  std::vector<std::vector<double>> coordinates(3);
  for (const Vec3& value : b)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      coordinates[static_cast<std::size_t>(axis)].push_back(value[axis]);
    }
  }
  return coordinates;
}

Eigen::MatrixXd columnsOf(const std::vector<std::vector<double>>& vectors)
{
  Eigen::MatrixXd columns(
    static_cast<Eigen::Index>(vectors.front().size()), static_cast<Eigen::Index>(vectors.size()));
  for (std::size_t c = 0; c < vectors.size(); ++c)
  {
    columns.col(static_cast<Eigen::Index>(c)) =
      Eigen::Map<const Eigen::VectorXd>(vectors[c].data(), columns.rows());
  }
  return columns;
}

/// All solves from zero, one right-hand side after another. Returns the mean of the iterations.
int solveEach(const evolving::SparseMatrix& A, const std::vector<std::vector<double>>& b,
  const SolverLimits& limits, evolving::Preconditioner* preconditioner)
{
  int iterations = 0;
  for (const std::vector<double>& column : b)
  {
    std::vector<double> x(column.size(), 0.0);
    iterations += evolving::conjugateGradients(A, column, x, limits, OneThread, preconditioner);
  }
  return iterations / static_cast<int>(b.size());
}

/// The methods by name; the table gets a row per mesh.
class Comparison
{
public:
  Comparison(std::string title, std::vector<std::string> columns, int runs)
    : Results(std::move(title), std::move(columns))
    , Runs(runs)
  {
  }

  void begin(std::size_t vertices) { this->Row = { std::to_string(vertices) }; }
  /// @param work returns the number of iterations, 0 for a direct method
  template <class Work>
  void measure(const Work& work)
  {
    int iterations = 0;
    const Seconds time = medianOf(this->Runs, [&] { iterations = work(); });
    this->Row.push_back(
      fixed(1e3 * time.cpu, 2) + (iterations > 0 ? " (" + std::to_string(iterations) + ")" : ""));
  }
  void end() { this->Results.add(this->Row); }
  void print(const std::string& note)
  {
    this->Results.note(note);
    this->Results.print();
  }

private:
  Table Results;
  int Runs;
  std::vector<std::string> Row;
};

void measureFactorizations(const evolving::SparseMatrix& A,
  const std::vector<std::vector<double>>& b, double tolerance, Comparison& comparison)
{
  const Eigen::MatrixXd columns = columnsOf(b);
  Eigen::MatrixXd x;
  comparison.measure(
    [&]
    {
      WithIncompleteCholesky solver(A);
      solver.setTolerance(tolerance);
      x = solver.solve(columns);
      requireSolved(solver);
      return static_cast<int>(solver.iterations());
    });
  Cholesky factors;
  comparison.measure(
    [&]
    {
      factors.analyzePattern(A);
      return 0;
    });
  comparison.measure(
    [&]
    {
      factors.factorize(A);
      requireSolved(factors);
      x = factors.solve(columns);
      return 0;
    });
}

void measureMultigrid(const evolving::SparseMatrix& A, const std::vector<std::vector<double>>& b,
  const SolverLimits& limits, Comparison& comparison)
{
  Multigrid multigrid;
  comparison.measure(
    [&]
    {
      multigrid.build(A, OneThread);
      return 0;
    });
  comparison.measure([&] { return solveEach(A, b, limits, &multigrid); });
}

void measurePositions(const StepSystems& systems, Comparison& comparison)
{
  const std::vector<Vec3>& b = systems.positionRightHandSide;
  const auto coordinates = coordinatesOf(b);
  comparison.measure(
    [&]
    {
      std::vector<Vec3> x(b.size(), Vec3::Zero());
      return evolving::conjugateGradients(systems.positionMatrix, b, x, PositionLimits, OneThread);
    });
  comparison.measure(
    [&] { return solveEach(systems.positionMatrix, coordinates, PositionLimits, nullptr); });
  measureFactorizations(systems.positionMatrix, coordinates, PositionLimits.tolerance, comparison);
  measureMultigrid(systems.positionMatrix, coordinates, PositionLimits, comparison);
}

/// @param next the systems a step later
void measurePotential(const StepSystems& systems, const StepSystems& next, Comparison& comparison)
{
  const std::vector<std::vector<double>> b{ systems.potentialRightHandSide };
  comparison.measure(
    [&] { return solveEach(systems.potentialMatrix, b, PotentialLimits, nullptr); });
  measureFactorizations(systems.potentialMatrix, b, PotentialLimits.tolerance, comparison);
  measureMultigrid(systems.potentialMatrix, b, PotentialLimits, comparison);

  evolving::PoissonSolver solver;
  std::vector<double> psi(b.front().size(), 0.0);
  solver.solve(systems.stiffness, systems.isPinned, b.front(), psi, PotentialLimits, OneThread);
  comparison.measure(
    [&]
    {
      std::vector<double> warm = psi;
      return solver.solve(next.stiffness, next.isPinned, next.potentialRightHandSide, warm,
        PotentialLimits, OneThread);
    });
}

} // namespace

int main(int argc, char** argv)
{
  Arguments defaults;
  defaults.sizes = { 2562, 10242, 40962, 163842 };
  defaults.threads = 1;
  const Arguments arguments = readArguments(argc, argv, defaults,
    "The linear systems of a step of the evolution by several solvers, on icospheres with bumps of"
    " --sizes vertices.");
  printHeader("SolverChoice", arguments);
  Comparison positions("Positions, three right-hand sides to 1e-10: CPU ms (iterations)",
    { "vertices", "CG + Jacobi at once", "one by one", "CG + inc. Cholesky", "LDLT: analysis",
      "factor + solves", "multigrid: build", "CG + multigrid" },
    arguments.runs);
  Comparison potential("Potential, to 1e-8: CPU ms (iterations)",
    { "vertices", "CG + Jacobi", "CG + inc. Cholesky", "LDLT: analysis", "factor + solve",
      "multigrid: build", "CG + multigrid", "a step later, lagged and warm" },
    arguments.runs);
  for (const int size : arguments.sizes)
  {
    const evolving::SurfaceMesh start = bumpySphere(levelOfVertices(size));
    const double tau = meanCoVolume(start);
    const StepSystems systems = systemsOfStep(start, tau);
    const StepSystems next = systemsOfStep(afterStep(start, systems), tau);
    positions.begin(start.points.size());
    measurePositions(systems, positions);
    positions.end();
    potential.begin(start.points.size());
    measurePotential(systems, next, potential);
    potential.end();
  }
  positions.print("one thread; tau the mean co-volume; all from zero, 'CG + multigrid' without the"
                  " build; LDLT's analysis is done once");
  potential.print("omega = 1; the last column is what the kernel does: the hierarchy of the step"
                  " before and its psi as the guess");
  return 0;
}
