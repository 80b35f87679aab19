// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Algebra/MinimalResidual.h"

#include "Errors.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;

namespace
{

class Dense : public SymmetricOperator
{
public:
  explicit Dense(const Eigen::MatrixXd& matrix)
    : A(matrix)
  {
  }

  void apply(const std::vector<double>& x, std::vector<double>& y, const Execution&) const override
  {
    const auto size = static_cast<Eigen::Index>(x.size());
    y.resize(x.size());
    Eigen::Map<Eigen::VectorXd>(y.data(), size) =
      this->A * Eigen::Map<const Eigen::VectorXd>(x.data(), size);
  }

private:
  Eigen::MatrixXd A;
};

class Scaling : public Preconditioner
{
public:
  explicit Scaling(const Eigen::VectorXd& factors)
    : Factors(factors)
  {
  }

  void apply(const std::vector<double>& r, std::vector<double>& z, const Execution&) override
  {
    z = r;
    for (std::size_t i = 0; i < z.size(); ++i)
    {
      z[i] *= this->Factors[static_cast<Eigen::Index>(i)];
    }
  }

private:
  Eigen::VectorXd Factors;
};

constexpr Eigen::Index Size = 30;

/// With eigenvalues of both signs.
Eigen::MatrixXd indefinite()
{
  std::srand(1);
  const Eigen::MatrixXd any = Eigen::MatrixXd::Random(Size, Size);
  return any + any.transpose();
}

std::vector<double> someVector()
{
  std::vector<double> b;
  for (Eigen::Index i = 0; i < Size; ++i)
  {
    b.push_back(std::sin(1.0 + 3.0 * static_cast<double>(i)));
  }
  return b;
}

double residual(
  const Eigen::MatrixXd& A, const std::vector<double>& x, const std::vector<double>& b)
{
  const Eigen::Map<const Eigen::VectorXd> right(b.data(), Size);
  return (A * Eigen::Map<const Eigen::VectorXd>(x.data(), Size) - right).norm() / right.norm();
}

} // namespace

TEST(MinimalResidual, SolvesWhatIsNotDefinite)
{
  const Eigen::MatrixXd A = indefinite();
  std::vector<double> x;
  SolverLimits limits;
  limits.tolerance = 1e-11;
  for (const double spread : { 0.0, 2.0 })
  {
    Scaling scaling((spread * Eigen::VectorXd::LinSpaced(Size, -1.0, 1.0)).array().exp().matrix());
    const int iterations = minimalResidual(Dense(A), someVector(), x, limits, scaling, Execution());
    EXPECT_LT(residual(A, x, someVector()), 1e-9);
    EXPECT_LT(iterations, 2 * Size);
  }
}

TEST(MinimalResidual, TakesAsManyIterationsAsThereAreEigenvalues)
{
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(indefinite());
  const Eigen::MatrixXd Q = qr.householderQ();
  Eigen::VectorXd eigenvalues = Eigen::VectorXd::Constant(Size, 2.0);
  eigenvalues.tail(10).setConstant(-1.0);
  std::vector<double> x;
  Scaling none(Eigen::VectorXd::Ones(Size));
  const int iterations = minimalResidual(Dense(Q * eigenvalues.asDiagonal() * Q.transpose()),
    someVector(), x, SolverLimits(), none, Execution());
  EXPECT_EQ(iterations, 2);
}

TEST(MinimalResidual, GivesZeroForZero)
{
  std::vector<double> x(3, 1.0);
  Scaling none(Eigen::VectorXd::Ones(Size));
  const std::vector<double> zero(Size, 0.0);
  EXPECT_EQ(minimalResidual(Dense(indefinite()), zero, x, SolverLimits(), none, Execution()), 0);
  EXPECT_EQ(x, zero);
}

TEST(MinimalResidual, SaysWhenItDoesNotGetThere)
{
  Eigen::MatrixXd singular = indefinite();
  singular.row(3).setZero();
  singular.col(3).setZero();
  std::vector<double> x;
  Scaling none(Eigen::VectorXd::Ones(Size));
  SolverLimits limits;
  limits.maximumIterations = 100;
  EXPECT_THROW(
    minimalResidual(Dense(singular), someVector(), x, limits, none, Execution()), SolverError);
  Scaling negative(-Eigen::VectorXd::Ones(Size));
  EXPECT_THROW(minimalResidual(Dense(indefinite()), someVector(), x, limits, negative, Execution()),
    SolverError);
}
