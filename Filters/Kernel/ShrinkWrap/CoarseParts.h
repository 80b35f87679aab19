// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Parts of a closed surface that have too few triangles to have a shape.
 */

#ifndef EVOLVING_COARSE_PARTS_H
#define EVOLVING_COARSE_PARTS_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

namespace evolving
{

/// Of the connected components of a surface.
struct CoarseParts
{
  double areaPart = 0.0;     ///< of the surface's area, in components of few triangles; 0 to 1
  double extent = 0.0;       ///< the diagonal of the box of the smallest of those; 0 without any
  Vec3 place = Vec3::Zero(); ///< on that one
  Index flat = 0;            ///< components that enclose no volume, or are inside out
  double flatExtent = 0.0;   ///< the diagonal of the box of the smallest of those
  Vec3 flatPlace = Vec3::Zero(); ///< on that one
};

/// @param surface triangles, closed, as it bounds a body: without cavities
CoarseParts findCoarseParts(const SurfaceMesh& surface);

} // namespace evolving

#endif
