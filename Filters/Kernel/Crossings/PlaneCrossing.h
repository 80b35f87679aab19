// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Where a segment runs through a plane.
 */

#ifndef EVOLVING_PLANE_CROSSING_H
#define EVOLVING_PLANE_CROSSING_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <cmath>

namespace evolving
{

/// How far along a segment, 0 to 1, the plane of a face is that its ends lie on both sides of.
inline double placeAtPlane(const SurfaceMesh& mesh, Index face, const Vec3& from, const Vec3& to)
{
  const Vec3 normal = faceVectorArea(mesh, face).stableNormalized();
  const Vec3& origin = mesh.facePoint(face, 0);
  const double before = std::abs(normal.dot(from - origin));
  const double after = std::abs(normal.dot(to - origin));
  return before + after > 0.0 ? before / (before + after) : 0.5;
}

} // namespace evolving

#endif
