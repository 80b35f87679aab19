// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The parts of a mesh that edges connect, and which are closed.
 */

#ifndef EVOLVING_SURFACE_PARTS_H
#define EVOLVING_SURFACE_PARTS_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <vector>

namespace evolving
{

struct SurfacePart
{
  bool isClosed = true; ///< are there two faces at every edge?
  double area = 0.0;
  double sixVolumes = 0.0; ///< signed; less than it is where faces are turned against each other

  double meanThickness() const; ///< twice the volume over the area
};

struct SurfaceParts
{
  std::vector<Index> ofFace; ///< by the part's first face
  std::vector<SurfacePart> list;
};

/// Does a face count? Where two of its corners were welded, a part is closed without it.
bool usesAPointTwice(const SurfaceMesh& surface, Index face);

/**
 * Faces that use a point twice have no say in whether a part is closed.
 * @param surface triangles, welded
 */
SurfaceParts surfaceParts(const SurfaceMesh& surface);

} // namespace evolving

#endif
