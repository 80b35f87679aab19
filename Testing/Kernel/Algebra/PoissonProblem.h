// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A Poisson problem on a closed surface, for the tests of its solvers.
 */

#ifndef EVOLVING_TESTING_POISSON_PROBLEM_H
#define EVOLVING_TESTING_POISSON_PROBLEM_H

#include "Algebra/SparseMatrix.h"
#include "Execution.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceMesh.h"
#include "Operators/FiniteVolumes.h"

#include <cmath>
#include <vector>

namespace evolving
{

struct PoissonProblem
{
  SurfaceMesh mesh;
  MeshTopology topology;
  FiniteVolumes volumes;
  std::vector<char> isPinned; ///< the first vertex

  explicit PoissonProblem(const SurfaceMesh& surface)
    : mesh(surface)
    , topology(mesh)
    , volumes(topology)
    , isPinned(mesh.points.size(), 0)
  {
    this->volumes.update(this->mesh, Execution());
    this->isPinned[0] = 1;
  }

  /// Smooth, and of sum zero.
  std::vector<double> rightHandSide() const
  {
    std::vector<double> b;
    double sum = 0.0;
    for (std::size_t i = 0; i < this->mesh.points.size(); ++i)
    {
      const Vec3& p = this->mesh.points[i];
      b.push_back(this->volumes.coVolumes()[i] * std::sin(2.0 * p.x() + p.y() * p.z()));
      sum += b.back();
    }
    for (double& value : b)
    {
      value -= sum / static_cast<double>(b.size());
    }
    return b;
  }

  /// Symmetric and positive definite.
  SparseMatrix pinnedMatrix() const
  {
    SparseMatrix A = this->volumes.stiffness();
    std::vector<double> b(this->mesh.points.size(), 0.0);
    eliminateKnown(this->isPinned, b, A, b, Execution());
    return A;
  }
};

} // namespace evolving

#endif
