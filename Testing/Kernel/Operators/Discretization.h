// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A surface with its matrices, for the tests that look at them.
 */

#ifndef EVOLVING_DISCRETIZATION_H
#define EVOLVING_DISCRETIZATION_H

#include "Execution.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceMesh.h"
#include "Operators/FiniteVolumes.h"

#include <Eigen/Dense>

namespace evolving
{

struct Discretization
{
  SurfaceMesh mesh;
  MeshTopology topology;
  FiniteVolumes volumes;

  explicit Discretization(const SurfaceMesh& surface, const Execution& execution = {})
    : mesh(surface)
    , topology(mesh)
    , volumes(topology)
  {
    this->volumes.update(this->mesh, execution);
  }
  Eigen::MatrixXd dense() const { return Eigen::MatrixXd(this->volumes.stiffness()); }
  double area() const { return totalArea(this->volumes.coVolumes(), Execution()); }
};

} // namespace evolving

#endif
