// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Section 4.4 of the thesis: the volume-based tangential velocity, in the form that is right and
 * in those that tables 6.2 and 6.3 were computed with in 2020.
 */

#ifndef BENCHMARK_THESIS_TANGENTIAL_H
#define BENCHMARK_THESIS_TANGENTIAL_H

#include "ThesisGeometry.h"

namespace benchmark
{

/// How L psi = b (4.24) is put together, and what its solution is taken for.
struct TangentialForm
{
  double curvatureSign;    ///< of mu_i (v_N.h)_i - mu_i / A sum_j mu_j (v_N.h)_j in b
  double uniformitySign;   ///< of omega (A / N - mu_i) in b
  bool skipsFirst;         ///< A, N and the sum leave out the vertex where psi = 0
  bool integralIsVelocity; ///< the first part of (4.27), neither less psi h nor divided by mu_i
                           ///< nor projected to the tangent plane, is added as v_T
};

/// Co-volumes grow even: the signs of (4.19) and (4.25) are printed the wrong way round.
constexpr TangentialForm RightForm{ -1.0, -1.0, false, false };
/// What the thesis's table 6.2 comes from, with omega = 1.
constexpr TangentialForm FormOfTable62{ 1.0, -1.0, true, true };
/// What its table 6.3 comes from, with omega = 10 (printed as 100).
constexpr TangentialForm FormOfTable63{ 1.0, 1.0, false, true };

/// b of (4.25) for mean curvature flow, v_N = h; 0 for the first vertex.
Eigen::VectorXd potentialRightHandSide(
  const ThesisGeometry& geometry, const TangentialForm& form, double omega);

/// v_T from psi by (4.27). @param F one vertex per row
Eigen::MatrixX3d tangentialVelocity(const Rings& rings, const Eigen::MatrixX3d& F,
  const ThesisGeometry& geometry, const Eigen::VectorXd& psi, const TangentialForm& form);

} // namespace benchmark

#endif
