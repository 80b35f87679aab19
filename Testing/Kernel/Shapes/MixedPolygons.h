// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Meshes of several kinds of polygons.
 */

#ifndef EVOLVING_TESTING_MIXED_POLYGONS_H
#define EVOLVING_TESTING_MIXED_POLYGONS_H

#include "Mesh/SurfaceMesh.h"

namespace evolving::shapes
{

/// Every `period`-th free vertex taken out, its triangles joined to one polygon: a mixed mesh.
SurfaceMesh withPolygons(const SurfaceMesh& triangles, Index period);

/// A sphere of triangles, quads, pentagons and hexagons.
SurfaceMesh mixedSphere(int level);

} // namespace evolving::shapes

#endif
