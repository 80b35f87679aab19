// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Back onto a surface that points have left a little.
 */

#ifndef EVOLVING_SURFACE_PROJECTOR_H
#define EVOLVING_SURFACE_PROJECTOR_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Trees/AABBTree.h"
#include "Types.h"

namespace evolving
{

/// The closest points of a surface.
class SurfaceProjector
{
public:
  /// @throws Cancelled
  explicit SurfaceProjector(const SurfaceMesh& surface, const Execution& execution = {});

  /**
   * The closest point of the surface, or `fallback` when the surface faces away from `normal`
   * there: a thin wall must not catch the points of its other side.
   */
  Vec3 project(const Vec3& point, const Vec3& normal, const Vec3& fallback) const;

private:
  AABBTree Tree;
};

} // namespace evolving

#endif
