// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ThesisScheme.h"

#include <Eigen/IterativeLinearSolvers>

#include <cstdlib>
#include <iostream>

namespace benchmark
{

namespace
{

using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Triplet = Eigen::Triplet<double>;
using Solver = Eigen::BiCGSTAB<Matrix, Eigen::DiagonalPreconditioner<double>>;

Matrix fromTriplets(const std::vector<Triplet>& triplets, Eigen::Index size)
{
  Matrix A(size, size);
  A.setFromTriplets(triplets.begin(), triplets.end());
  return A;
}

/// I + tau diag(epsilon / mu) L (4.17), epsilon = 1: not symmetric.
Matrix evolutionMatrix(const ThesisGeometry& geometry, double tau)
{
  std::vector<Triplet> triplets;
  triplets.reserve(geometry.L.size() + static_cast<std::size_t>(geometry.mu.size()));
  for (const Triplet& w : geometry.L)
  {
    triplets.emplace_back(w.row(), w.col(), tau / geometry.mu[w.row()] * w.value());
  }
  for (int i = 0; i < static_cast<int>(geometry.mu.size()); ++i)
  {
    triplets.emplace_back(i, i, 1.0);
  }
  return fromTriplets(triplets, geometry.mu.size());
}

/// A^psi of (4.24): L, whose first row says psi_0 = 0.
Matrix potentialMatrix(const ThesisGeometry& geometry)
{
  std::vector<Triplet> triplets{ { 0, 0, 1.0 } };
  triplets.reserve(geometry.L.size());
  for (const Triplet& w : geometry.L)
  {
    if (w.row() != 0)
    {
      triplets.push_back(w);
    }
  }
  return fromTriplets(triplets, geometry.mu.size());
}

/// Adds the number of iterations to the count.
Eigen::VectorXd solved(
  const Matrix& A, const Eigen::VectorXd& b, double tolerance, long long& count)
{
  Solver solver(A);
  solver.setTolerance(tolerance);
  Eigen::VectorXd x = solver.solve(b);
  if (solver.info() != Eigen::Success)
  {
    std::cerr << "BiCGSTAB ended after " << solver.iterations() << " iterations at a residual of "
              << solver.error() << ", expected " << tolerance << ".\n";
    std::exit(1);
  }
  count += solver.iterations();
  return x;
}

} // namespace

ThesisScheme::ThesisScheme(const evolving::SurfaceMesh& start, const ThesisTolerances& tolerances)
  : Neighbours(ringsOf(start))
  , Tolerances(tolerances)
  , F(start.vertexCount(), 3)
  , Psi(Eigen::VectorXd::Zero(start.vertexCount()))
{
  for (evolving::Index i = 0; i < start.vertexCount(); ++i)
  {
    this->F.row(i) = start.points[static_cast<std::size_t>(i)];
  }
}

void ThesisScheme::redistribute(const TangentialForm& form, double omega)
{
  this->Redistributes = true;
  this->Form = form;
  this->Omega = omega;
}

void ThesisScheme::step(double tau)
{
  this->Geometry = thesisGeometry(this->Neighbours, this->F);
  Eigen::MatrixX3d b = this->F; // (4.16), eta = 0
  if (this->Redistributes)
  {
    this->solvePotential();
    b += tau * tangentialVelocity(this->Neighbours, this->F, this->Geometry, this->Psi, this->Form);
  }
  this->solvePositions(tau, b);
}

void ThesisScheme::solvePotential()
{
  const Eigen::VectorXd b = potentialRightHandSide(this->Geometry, this->Form, this->Omega);
  this->Psi = solved(
    potentialMatrix(this->Geometry), b, this->Tolerances.potential, this->PotentialIterations);
}

void ThesisScheme::solvePositions(double tau, const Eigen::MatrixX3d& b)
{
  const Matrix A = evolutionMatrix(this->Geometry, tau);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->F.col(axis) =
      solved(A, b.col(axis), this->Tolerances.positions, this->CoordinateIterations);
  }
}

} // namespace benchmark
