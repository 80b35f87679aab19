// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The two linear systems of a step of mean curvature flow with redistribution, to solve by any
 * means.
 */

#ifndef BENCHMARK_STEP_SYSTEMS_H
#define BENCHMARK_STEP_SYSTEMS_H

#include "Algebra/SparseMatrix.h"
#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace benchmark
{

struct StepSystems
{
  /// Of the displacement: diag(mu) + tau L, and tau mu h; epsilon = 1.
  evolving::SparseMatrix positionMatrix;
  std::vector<evolving::Vec3> positionRightHandSide;
  /// Of psi, omega = 1: L without the row and the column of the pinned vertex.
  evolving::SparseMatrix stiffness;
  evolving::SparseMatrix potentialMatrix;
  std::vector<double> potentialRightHandSide;
  std::vector<char> isPinned;
};

/// @param mesh closed and connected
StepSystems systemsOfStep(const evolving::SurfaceMesh& mesh, double tau);

/// The surface moved by the solution of the first system.
evolving::SurfaceMesh afterStep(evolving::SurfaceMesh mesh, const StepSystems& systems);

} // namespace benchmark

#endif
