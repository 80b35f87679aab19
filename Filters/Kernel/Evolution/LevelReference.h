// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How far from its target new elements of a surface may be.
 */

#ifndef EVOLVING_LEVEL_REFERENCE_H
#define EVOLVING_LEVEL_REFERENCE_H

#include "Evolution/ScalarImage.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Remeshing/ReferenceSurface.h"
#include "Trees/AABBTree.h"

#include <vector>

namespace evolving
{

/**
 * No place of a surface is to be farther from its target for being remeshed. Where that is curved
 * more than its elements can show, at the tip of an ear or in the fold below it, new elements lie
 * off the old surface by a part of their size, which at the end of a flow nothing makes good. The
 * foot of a point that is farther from the target than the old surface is there, lies along the
 * gradient of the distance where it is as far; any other point is its own foot.
 */
class LevelReference : public ReferenceSurface
{
public:
  /**
   * @param target its distance, signed or not; must outlive this object
   * @param surface before it is remeshed, triangles
   * @param distance from the target, of its vertices
   * @throws Cancelled
   */
  LevelReference(const ScalarImage& target, const SurfaceMesh& surface,
    const std::vector<double>& distance, const Execution& execution = {});

  Foot onSurface(const Vec3& point, const Vec3& facing, Index label, Index guess) const override;

private:
  double distanceOfSurface(const Vec3& point) const;

  const ScalarImage& Target;
  SurfaceMesh Surface;
  std::vector<double> Distance;
  AABBTree Tree;
};

} // namespace evolving

#endif
