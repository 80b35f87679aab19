// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The tangential velocity v_T of (4.1): the sum of its three kinds, kept within what one step can
 * do and within what the boundary allows.
 */

#ifndef EVOLVING_TANGENTIAL_VELOCITY_H
#define EVOLVING_TANGENTIAL_VELOCITY_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Operators/SurfaceGeometry.h"
#include "Redistribution/LengthRedistribution.h"
#include "Redistribution/RedistributionOptions.h"
#include "Redistribution/SurfaceCurves.h"
#include "Redistribution/VolumeRedistribution.h"

#include <vector>

namespace evolving
{

/// The state of a surface that its tangential velocity depends on.
struct TangentialInput
{
  const SurfaceMesh& mesh;
  const SurfaceGeometry& geometry;
  const std::vector<Vec3>& normalVelocity; ///< v_N = epsilon h + eta N
  const std::vector<double>& distance;     ///< d, or empty
  double distanceScale = 1.0;              ///< a length: the size of the target
  double timeStep = 1.0;                   ///< what v_T will be multiplied by
};

class TangentialVelocity
{
public:
  /// @param options in absolute units; topology and curves must outlive this object
  TangentialVelocity(const MeshTopology& topology, const SurfaceCurves& curves,
    const RedistributionOptions& options, BoundaryMode boundaryMode, double solverTolerance);

  /**
   * v_T, orthogonal to the normals. No vertex moves farther in a step than half the mean length
   * of its edges. Corners of curves do not move and other vertices of curves move along them;
   * boundary vertices stay (Fixed) or move like inner ones (Free).
   * @throws SolverError, Cancelled
   */
  std::vector<Vec3> velocity(const TangentialInput& input, const Execution& execution);

  /// From now on without the volume-based velocity, for which there was no psi.
  void dropVolume();

  /// psi; zero when the volume-based velocity is switched off.
  const std::vector<double>& potential() const { return this->Volume.potential(); }
  /// Of the last solve for psi.
  int iterations() const { return this->Volume.iterations(); }

private:
  void addParts(const TangentialInput& input, const std::vector<Vec3>& tangents,
    std::vector<Vec3>& velocity, const Execution& execution);
  void limit(const TangentialInput& input, const std::vector<Vec3>& tangents,
    std::vector<Vec3>& velocity, const Execution& execution) const;

  const SurfaceCurves& Curves;
  RedistributionOptions Options;
  BoundaryMode Boundary;
  double SolverTolerance;
  VolumeRedistribution Volume;
  std::vector<LengthRedistribution> Length; ///< one when it is switched on
};

} // namespace evolving

#endif
