// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Algebra/Multigrid.h"

#include "Algebra/PoissonProblem.h"
#include "Errors.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "ThreadedExecution.h"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace evolving;

namespace
{

using Vector = Eigen::VectorXd;

std::vector<double> unitVector(std::size_t size, std::size_t i)
{
  std::vector<double> unit(size, 0.0);
  unit[i] = 1.0;
  return unit;
}

Vector randomVector(Eigen::Index size, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  return Vector::NullaryExpr(size, [&] { return uniform(random); });
}

Vector applied(Multigrid& multigrid, const Vector& r, const Execution& execution = {})
{
  std::vector<double> z;
  multigrid.apply(std::vector<double>(r.data(), r.data() + r.size()), z, execution);
  return Eigen::Map<const Vector>(z.data(), static_cast<Eigen::Index>(z.size()));
}

double energy(const SparseMatrix& A, const Vector& x)
{
  return x.dot(A * x);
}

/// Vertices moved so far that many angles are obtuse: weights of both signs.
PoissonProblem obtuseProblem()
{
  SurfaceMesh mesh = shapes::shakenSphere(5, 0.35, 3);
  for (Vec3& p : mesh.points)
  {
    p.z() *= 0.2;
  }
  return PoissonProblem(mesh);
}

} // namespace

TEST(Multigrid, IsSymmetricAndPositiveDefinite)
{
  const PoissonProblem problem(shapes::bumpySphere(5)); // two levels
  Multigrid multigrid;
  multigrid.build(problem.pinnedMatrix(), Execution());
  EXPECT_GE(multigrid.levelCount(), 2);
  const std::size_t n = problem.mesh.points.size();
  std::vector<double> fromFirst;
  std::vector<double> fromSecond;
  for (const std::size_t i : { std::size_t(5), std::size_t(1234), std::size_t(9000) })
  {
    for (const std::size_t j : { std::size_t(6), std::size_t(77), std::size_t(10241) })
    {
      multigrid.apply(unitVector(n, i), fromFirst, Execution());
      multigrid.apply(unitVector(n, j), fromSecond, Execution());
      EXPECT_NEAR(fromFirst[j], fromSecond[i], 1e-12 * fromFirst[i]);
      EXPECT_GT(fromFirst[i], 0.0);
    }
  }
}

TEST(Multigrid, IterationsDoNotGrowWithTheMesh)
{
  std::vector<int> iterations;
  for (const int level : { 4, 5, 6 })
  {
    const PoissonProblem problem(shapes::bumpySphere(level));
    const SparseMatrix A = problem.pinnedMatrix();
    std::vector<double> b = problem.rightHandSide();
    b[0] = 0.0;
    std::vector<double> psi(b.size(), 0.0);
    Multigrid multigrid;
    multigrid.build(A, Execution());
    const SolverLimits limits{ 1e-8, 1000 };
    iterations.push_back(conjugateGradients(A, b, psi, limits, Execution(), &multigrid));
    std::vector<double> plain(b.size(), 0.0);
    EXPECT_LT(4 * iterations.back(), conjugateGradients(A, b, plain, limits, Execution()));
  }
  EXPECT_LE(iterations[0], 2); // factorized
  EXPECT_LE(iterations[2], iterations[1] + 6);
  EXPECT_LE(iterations[2], 30);
}

TEST(Multigrid, OfASmallMatrixIsItsInverse)
{
  const PoissonProblem problem(shapes::bumpySphere(2));
  const SparseMatrix A = problem.pinnedMatrix();
  Multigrid multigrid;
  multigrid.build(A, Execution());
  EXPECT_EQ(multigrid.levelCount(), 1);
  const Vector x = randomVector(A.rows(), 1);
  EXPECT_LT((applied(multigrid, A * x) - x).norm(), 1e-12 * x.norm());
}

TEST(Multigrid, IsLinear)
{
  const PoissonProblem problem(shapes::bumpySphere(5));
  Multigrid multigrid;
  multigrid.build(problem.pinnedMatrix(), Execution());
  const Vector a = randomVector(problem.mesh.vertexCount(), 2);
  const Vector b = randomVector(problem.mesh.vertexCount(), 3);
  const Vector expected = 3.0 * applied(multigrid, a) - 0.7 * applied(multigrid, b);
  EXPECT_LT((applied(multigrid, 3.0 * a - 0.7 * b) - expected).norm(), 1e-12 * expected.norm());
}

TEST(Multigrid, ACycleBringsAnySolutionNearer)
{
  // The iteration x += M (b - A x) converges for every positive definite matrix, so that the error
  // falls in the norm of A whatever it is: smooth, rough, or in one place.
  for (const PoissonProblem& problem : { PoissonProblem(shapes::bumpySphere(5)), obtuseProblem() })
  {
    const SparseMatrix A = problem.pinnedMatrix();
    Multigrid multigrid;
    multigrid.build(A, Execution());
    ASSERT_GE(multigrid.levelCount(), 2);
    const Eigen::Index n = A.rows();
    for (Vector error :
      { randomVector(n, 4), Vector(Vector::Ones(n)), Vector(Vector::Unit(n, 99)) })
    {
      for (int cycle = 0; cycle < 10; ++cycle)
      {
        const double before = energy(A, error);
        error -= applied(multigrid, A * error);
        EXPECT_LT(energy(A, error), before);
      }
    }
  }
}

TEST(Multigrid, ConvergesFastOnAGoodMesh)
{
  const PoissonProblem problem(icosphere(5));
  const SparseMatrix A = problem.pinnedMatrix();
  Multigrid multigrid;
  multigrid.build(A, Execution());
  Vector error = randomVector(A.rows(), 5);
  const double before = energy(A, error);
  constexpr int Cycles = 20;
  for (int cycle = 0; cycle < Cycles; ++cycle)
  {
    error -= applied(multigrid, A * error);
  }
  // The mean factor of a cycle in the norm of A.
  EXPECT_LT(std::pow(energy(A, error) / before, 0.5 / Cycles), 0.8);
}

TEST(Multigrid, ScalesWithTheMatrixBitForBit)
{
  const PoissonProblem problem(shapes::bumpySphere(5));
  const SparseMatrix A = problem.pinnedMatrix();
  const Vector r = randomVector(A.rows(), 6);
  Multigrid multigrid;
  multigrid.build(A, Execution());
  const Vector expected = applied(multigrid, r);
  for (const double scale : { 0x1p-30, 0x1p30 })
  {
    multigrid.build(SparseMatrix(scale * A), Execution());
    EXPECT_EQ(Vector(scale * applied(multigrid, r)), expected) << scale;
  }
}

TEST(Multigrid, IterationsHardlyDependOnTheNumbering)
{
  const SurfaceMesh mesh = shapes::bumpySphere(5);
  std::mt19937 generator(8);
  std::vector<int> iterations;
  for (const SurfaceMesh& numbered : { mesh, shapes::shuffled(mesh, generator) })
  {
    const PoissonProblem problem(numbered);
    const SparseMatrix A = problem.pinnedMatrix();
    std::vector<double> b = problem.rightHandSide();
    b[0] = 0.0;
    std::vector<double> psi(b.size(), 0.0);
    Multigrid multigrid;
    multigrid.build(A, Execution());
    iterations.push_back(conjugateGradients(A, b, psi, { 1e-8, 1000 }, Execution(), &multigrid));
  }
  EXPECT_NEAR(iterations[0], iterations[1], 6);
}

TEST(Multigrid, OfRowsThatKnowNothingOfEachOtherDividesByTheDiagonal)
{
  // Nothing to aggregate, however many rows there are.
  const Index n = 20000;
  SparseMatrix A(n, n);
  A.reserve(Eigen::VectorXi::Ones(n));
  const Vector diagonal = randomVector(n, 9).array() + 2.0;
  for (Index i = 0; i < n; ++i)
  {
    A.insert(i, i) = diagonal[i];
  }
  A.makeCompressed();
  Multigrid multigrid;
  multigrid.build(A, Execution());
  const Vector r = randomVector(n, 10);
  const Vector expected = r.cwiseQuotient(diagonal);
  EXPECT_LT((applied(multigrid, r) - expected).norm(), 1e-15 * expected.norm());
}

TEST(Multigrid, BuiltAgainForgetsTheMatrixBefore)
{
  const PoissonProblem first(shapes::bumpySphere(5));
  const PoissonProblem second(shapes::ellipsoid(5, Vec3(1.0, 2.0, 0.5)));
  const Vector r = randomVector(second.mesh.vertexCount(), 11);
  Multigrid fresh;
  fresh.build(second.pinnedMatrix(), Execution());
  Multigrid used;
  used.build(first.pinnedMatrix(), Execution());
  applied(used, r);
  used.build(second.pinnedMatrix(), Execution());
  EXPECT_EQ(used.levelCount(), fresh.levelCount());
  EXPECT_EQ(applied(used, r), applied(fresh, r));
}

TEST(Multigrid, RefusesMatricesThatAreNotPositiveDefinite)
{
  for (const int level : { 2, 5 })
  {
    SparseMatrix A = PoissonProblem(shapes::bumpySphere(level)).pinnedMatrix();
    A *= -1.0;
    Multigrid multigrid;
    EXPECT_THROW(multigrid.build(A, Execution()), SolverError) << level;
  }
}

TEST(Multigrid, CanBeCancelledBetweenLevels)
{
  const SparseMatrix A = PoissonProblem(shapes::bumpySphere(5)).pinnedMatrix();
  const auto serially = [](std::int64_t count, const std::function<void(std::int64_t)>& task)
  {
    for (std::int64_t i = 0; i < count; ++i)
    {
      task(i);
    }
  };
  const Execution stopping(serially, nullptr, [] { return true; });
  Multigrid multigrid;
  EXPECT_THROW(multigrid.build(A, stopping), Cancelled);
}

TEST(Multigrid, HasTheSameBitsOnAnyThreads)
{
  const PoissonProblem problem(shapes::bumpySphere(5));
  const SparseMatrix A = problem.pinnedMatrix();
  const Vector r = randomVector(A.rows(), 12);
  Multigrid serial;
  serial.build(A, Execution());
  const Vector expected = applied(serial, r);
  for (const int threads : { 1, 2, 8 })
  {
    Multigrid multigrid;
    multigrid.build(A, threadedExecution(threads, 3));
    EXPECT_EQ(applied(multigrid, r, threadedExecution(threads, 4)), expected) << threads;
  }
}
