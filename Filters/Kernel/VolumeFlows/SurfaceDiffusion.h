// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Surface diffusion: d_t F = b Laplace_S H N, which keeps the volume and shrinks the area.
 */

#ifndef EVOLVING_SURFACE_DIFFUSION_H
#define EVOLVING_SURFACE_DIFFUSION_H

#include "Algebra/SparseMatrix.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Operators/SurfaceGeometry.h"

#include <vector>

namespace evolving
{

/**
 * The velocity of a semi-implicit step, in the finite volumes of the other flows. With g_i the
 * gradient of the volume, m_i its length and n_i its direction, the step moves point i by d_i n_i,
 * and the new mean curvatures H are those that the new surface has by this step's matrices:
 *
 *   m H = n . L (F + d n)           m d = -tau b L H
 *
 * So sum m_i d_i = 0: the volume changes by terms of second order in d alone; and multiplied by d
 * and H they say that the area falls by tau b H . L H at least, whatever the step (as for the
 * scheme of Barrett, Garcke, Nuernberg, *On the parametric approximation of evolving
 * hypersurfaces*, 2008, without its tangential motion, which is TangentialVelocity's task here).
 */
class SurfaceDiffusion
{
public:
  /// @param speed b, length^4/time @param tolerance of the linear solver
  SurfaceDiffusion(double speed, double tolerance);

  /**
   * d n / tau, one per vertex.
   * @param isHeld vertices that rest; for surfaces without boundary: those without faces
   * @throws SolverError, Cancelled
   */
  std::vector<Vec3> velocity(const SurfaceMesh& mesh, const SurfaceGeometry& geometry,
    const std::vector<char>& isHeld, double timeStep, const Execution& execution);

  /// Of the last solve.
  int iterations() const { return this->Iterations; }

private:
  double Speed;
  double Tolerance;
  int Iterations = 0;
};

} // namespace evolving

#endif
