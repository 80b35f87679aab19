// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ThesisTangential.h"

namespace benchmark
{

namespace
{

using evolving::Index;
using evolving::Vec3;

/// |sigma| psi nu of one co-volume edge, that beside the edge from F_i to its neighbour.
Vec3 boundaryTerm(const Vec3& F_i, const Vec3& neighbour, const Vec3& B, double psi)
{
  const Vec3 M = 0.5 * (F_i + neighbour);
  const Vec3 sigma = B - M;
  const Vec3 e = M - F_i;
  const Vec3 nu = (e - e.dot(sigma) / sigma.dot(sigma) * sigma).normalized();
  return sigma.norm() * psi * nu;
}

/// The integral of psi nu along the boundary of co-volume i.
Vec3 boundaryIntegral(
  const std::vector<Index>& ring, Index i, const Eigen::MatrixX3d& F, const Eigen::VectorXd& psi)
{
  const Vec3 F_i = F.row(i);
  Vec3 integral = Vec3::Zero();
  for (int p = 0; p < static_cast<int>(ring.size()); ++p)
  {
    const Index i_1 = around(ring, p);
    const Index i_2 = around(ring, p + 1);
    const Vec3 F_1 = F.row(i_1);
    const Vec3 F_2 = F.row(i_2);
    const Vec3 B = (F_i + F_1 + F_2) / 3.0;
    integral += boundaryTerm(F_i, F_1, B, (5.0 * psi[i] + 5.0 * psi[i_1] + 2.0 * psi[i_2]) / 12.0);
    integral += boundaryTerm(F_i, F_2, B, (5.0 * psi[i] + 2.0 * psi[i_1] + 5.0 * psi[i_2]) / 12.0);
  }
  return integral;
}

/// Angle-weighted (algorithm 2).
Vec3 pseudonormal(const std::vector<Index>& ring, Index i, const Eigen::MatrixX3d& F)
{
  Vec3 N = Vec3::Zero();
  for (int p = 0; p < static_cast<int>(ring.size()); ++p)
  {
    const Vec3 e_0 = (F.row(around(ring, p)) - F.row(i)).normalized();
    const Vec3 e_1 = (F.row(around(ring, p + 1)) - F.row(i)).normalized();
    N += std::acos(e_0.dot(e_1)) * e_0.cross(e_1).normalized();
  }
  return N.normalized();
}

} // namespace

Eigen::VectorXd potentialRightHandSide(
  const ThesisGeometry& geometry, const TangentialForm& form, double omega)
{
  const Eigen::Index from = form.skipsFirst ? 1 : 0;
  const Eigen::Index count = geometry.mu.size() - from;
  const Eigen::VectorXd& mu = geometry.mu;
  const Eigen::VectorXd loss = mu.cwiseProduct(geometry.h.rowwise().squaredNorm()); // v_N = h
  const double A = mu.tail(count).sum();
  const double totalLoss = loss.tail(count).sum();
  Eigen::VectorXd b(mu.size());
  for (Eigen::Index i = 0; i < mu.size(); ++i)
  {
    b[i] = form.curvatureSign * (loss[i] - mu[i] / A * totalLoss) +
      form.uniformitySign * omega * (A / static_cast<double>(count) - mu[i]);
  }
  b[0] = 0.0; // psi_0 = 0
  return b;
}

Eigen::MatrixX3d tangentialVelocity(const Rings& rings, const Eigen::MatrixX3d& F,
  const ThesisGeometry& geometry, const Eigen::VectorXd& psi, const TangentialForm& form)
{
  Eigen::MatrixX3d v_T(F.rows(), 3);
  for (Index i = 0; i < static_cast<Index>(F.rows()); ++i)
  {
    const std::vector<Index>& ring = rings[static_cast<std::size_t>(i)];
    Vec3 v = boundaryIntegral(ring, i, F, psi);
    if (!form.integralIsVelocity)
    {
      const Vec3 h = geometry.h.row(i);
      const Vec3 N = pseudonormal(ring, i, F);
      v = v / geometry.mu[i] - psi[i] * h;
      v -= v.dot(N) * N;
    }
    v_T.row(i) = v;
  }
  return v_T;
}

} // namespace benchmark
