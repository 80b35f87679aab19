// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The volume that a surface encloses, component by component, and how it depends on the points.
 */

#ifndef EVOLVING_ENCLOSED_VOLUME_H
#define EVOLVING_ENCLOSED_VOLUME_H

#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving
{

/**
 * signedVolume() of every connected component. That of a component with a boundary is the volume of
 * the cone from the middle of the box around it: it changes by what the surface sweeps, as long as
 * the boundary rests.
 */
std::vector<double> componentVolumes(const SurfaceMesh& mesh, const MeshTopology& topology);

/**
 * The gradient of signedVolume() by the points, in length^2: a vector along the normals, nearly
 * mu_i N_i. Exact at vertices that no boundary goes through; polygons count as fans around their
 * first corner, as they do in the volume.
 */
std::vector<Vec3> volumeGradient(const SurfaceMesh& mesh);

} // namespace evolving

#endif
