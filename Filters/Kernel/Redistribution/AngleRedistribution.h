// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The angle-based tangential velocity (section 3.3.3): a vertex moves so that the angles between
 * its edges grow equal.
 */

#ifndef EVOLVING_ANGLE_REDISTRIBUTION_H
#define EVOLVING_ANGLE_REDISTRIBUTION_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Operators/SurfaceGeometry.h"
#include "Redistribution/RedistributionOptions.h"

#include <vector>

namespace evolving
{

/**
 * (3.24) before projection: omega / M sum_j (1 + cos theta_j)(e_j + e_j+1) over the M edges e_j
 * around a vertex, theta_j the angle between two consecutive ones. At the boundary the sum runs
 * over the pairs inside the surface. Zero for a vertex without faces.
 */
Vec3 angleVelocity(
  const SurfaceMesh& mesh, const MeshTopology& topology, Index vertex, double rate);

/// The smallest altitude of the triangles that a vertex's pairs of consecutive edges span and of
/// its faces' other corners; infinite without faces.
double smallestAltitude(const SurfaceMesh& mesh, const MeshTopology& topology, Index vertex);

/**
 * v_T by (3.24), projected to the tangent planes, and shortened so that no vertex moves farther in
 * a step than a quarter of its smallest altitude; or omega times the way to the vertex's best
 * place, see bestShapeMove(). Both with section 6.2's weights.
 *
 * InverseArea: times mean co-volume / mu_i, at most 1. Distance: times |d| / distanceScale, at
 * most 1; without distances it changes nothing.
 * @param tangents of curves, as SurfaceCurves::tangents() gives them
 * @param options angle (omega), angleMethod and angleWeighting are used
 * @param distance d at the vertices, or empty
 * @param distanceScale a length: the size of the target
 * @param timeStep what v_T will be multiplied by
 */
std::vector<Vec3> angleRedistribution(const SurfaceMesh& mesh, const SurfaceGeometry& geometry,
  const std::vector<Vec3>& tangents, const RedistributionOptions& options,
  const std::vector<double>& distance, double distanceScale, double timeStep,
  const Execution& execution);

} // namespace evolving

#endif
