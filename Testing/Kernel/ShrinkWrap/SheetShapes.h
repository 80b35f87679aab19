// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Sheets beside closed shapes with what a ball can reach of the space around them.
 */

#ifndef EVOLVING_TESTING_SHEET_SHAPES_H
#define EVOLVING_TESTING_SHEET_SHAPES_H

#include "Mesh/SurfaceMesh.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/SampledOnGrid.h"
#include "Shapes/Sheets.h"
#include "ShrinkWrap/OuterRegion.h"
#include "Trees/AABBTree.h"

#include <cmath>

namespace evolving::wraps
{

/// A target, its tree and the region that a ball of a tenth of the target's extent reaches.
struct ReachedTarget
{
  SurfaceMesh mesh;
  AABBTree tree;
  double radius;
  OuterRegion region;

  explicit ReachedTarget(const SurfaceMesh& surface, double scale = 1.0)
    : mesh(shapes::transformed(surface, scale, Vec3::Zero()))
    , tree(mesh)
    , radius(0.2 * scale)
    , region(regionOf(tree, radius, scale))
  {
  }

private:
  static OuterRegion regionOf(const AABBTree& tree, double radius, double scale)
  {
    const DistanceGrid grid = shapes::cubicGrid(49, 1.8 * scale);
    return OuterRegion(grid,
      shapes::sampled(grid,
        [&](const Vec3& p) { return std::sqrt(tree.closest(p).at.squaredDistance) - radius; }),
      radius);
  }
};

/// The square [-1, 1]^2 at a height.
inline SurfaceMesh plate(Index squares, double height = 0.0)
{
  return shapes::transformed(shapes::sheet(squares, true), 2.0, Vec3(-1.0, -1.0, height));
}

/// A plate and a box on its right half, 0.1 above it: nothing comes between them.
inline SurfaceMesh coveredPlate(Index squares)
{
  return shapes::merged(plate(squares), shapes::box(Vec3(0.0, -1.2, 0.1), Vec3(1.2, 1.2, 0.6)));
}

} // namespace evolving::wraps

#endif
