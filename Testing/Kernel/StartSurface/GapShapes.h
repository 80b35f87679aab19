// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Distances from shapes with gaps of known width, for the tests of this folder.
 */

#ifndef EVOLVING_TESTING_GAP_SHAPES_H
#define EVOLVING_TESTING_GAP_SHAPES_H

#include "Mesh/SurfaceMesh.h"
#include "Shapes/SampledOnGrid.h"
#include "StartSurface/Isosurface.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace evolving::shapes
{

/// From two boxes, 1 x 0.8 x 0.8 with the slot between them, which is parallel to the yz plane.
inline double slotDistance(const Vec3& p, double width)
{
  const double halfX = 0.5 * (0.5 - 0.5 * width);
  const Vec3 centre(0.5 - halfX, 0.0, 0.0);
  const Vec3 halfSides(halfX, 0.4, 0.4);
  return std::min(
    std::abs(boxDistance(p - centre, halfSides)), std::abs(boxDistance(p + centre, halfSides)));
}

/// From a sphere of radius 0.5 without what lies within an angle of its pole.
inline double bowlDistance(const Vec3& p, double openingAngle)
{
  constexpr double Radius = 0.5;
  const double across = std::hypot(p.x(), p.y());
  if (std::atan2(across, p.z()) >= openingAngle)
  {
    return std::abs(p.norm() - Radius);
  }
  return std::hypot(
    across - Radius * std::sin(openingAngle), p.z() - Radius * std::cos(openingAngle));
}

/// The outer surface of the region below zero.
inline SurfaceMesh outerSurface(const DistanceGrid& grid, const std::vector<float>& field)
{
  IsosurfaceOptions options;
  options.fillCavities = true;
  return isosurface(grid, field, options);
}

} // namespace evolving::shapes

#endif
