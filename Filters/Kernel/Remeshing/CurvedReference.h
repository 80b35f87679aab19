// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A triangle mesh as the smooth surface that it stands for.
 */

#ifndef EVOLVING_CURVED_REFERENCE_H
#define EVOLVING_CURVED_REFERENCE_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Remeshing/ReferenceSurface.h"
#include "Trees/AABBTree.h"

#include <vector>

namespace evolving
{

/**
 * Triangles bulged by half of what the tangent planes at their corners say (Boubekeur, Alexa,
 * *Phong Tessellation*, 2008). With one half the bulge of a flat triangle between points of a
 * surface is that of the surface to second order: h = k/2 sum_{i<j} b_i b_j |e_ij|^2, and the
 * tangent planes lie at sum b_i (k/2 |p - x_i|^2 + h) = 2 h. On a sphere what remains falls with
 * the fourth power of the edge. So a surface that is remeshed on itself again and again does not
 * shrink. Where the normal of a corner differs from the triangle's by more than 30 degrees it stays
 * flat: a crease or a needle is not smooth.
 */
class CurvedReference : public ReferenceSurface
{
public:
  /// @throws InputError when a face is not a triangle. @throws Cancelled
  explicit CurvedReference(const SurfaceMesh& triangles, const Execution& execution = {});

  Foot onSurface(const Vec3& point, const Vec3& facing, Index label, Index guess) const override;

private:
  SurfaceMesh Mesh;
  AABBTree Tree;
  std::vector<Vec3> Normals; ///< of the vertices
};

} // namespace evolving

#endif
