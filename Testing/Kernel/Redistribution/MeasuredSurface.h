// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A surface with its normals, co-volumes and curvature, for the tests of velocities.
 */

#ifndef EVOLVING_MEASURED_SURFACE_H
#define EVOLVING_MEASURED_SURFACE_H

#include "Execution.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceMesh.h"
#include "Operators/SurfaceGeometry.h"

namespace evolving
{

struct MeasuredSurface
{
  SurfaceMesh mesh;
  MeshTopology topology;
  SurfaceGeometry geometry;

  explicit MeasuredSurface(const SurfaceMesh& surface)
    : mesh(surface)
    , topology(mesh)
    , geometry(topology)
  {
    this->geometry.update(this->mesh, Execution());
  }
};

} // namespace evolving

#endif
