// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What can be reached of the space around a target: the region that the start surface bounds.
 */

#ifndef EVOLVING_OUTER_REGION_H
#define EVOLVING_OUTER_REGION_H

#include "Distance/DistanceGrid.h"
#include "Evolution/ScalarImage.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving
{

/**
 * The samples from which a ball of a radius can roll to the grid's border without touching the
 * target. What it cannot reach is inside, cavities and all that floats in them: so the
 * orientation of the target never matters.
 */
class OuterRegion
{
public:
  /**
   * @param field below zero where the ball touches: the distance from the target less the radius
   * @throws InputError as InsideSamples. @throws Cancelled
   */
  OuterRegion(const DistanceGrid& grid, std::vector<float> field, double radius,
    const Execution& execution = {});

  /// The closed surface between the region and the rest, outwards; specks are left out.
  SurfaceMesh boundary(const Execution& execution = {}) const;

  /// Can the ball's centre come to a point? 1 where it can, 0 where not, smooth between.
  double reachable(const Vec3& point) const;
  /// Does the ball's centre not even come within a cell?
  bool isFarFrom(const Vec3& point) const;
  /// Is a sample of the grid, by its number, one that the ball's centre comes to?
  bool contains(std::size_t sample) const { return this->Height.values()[sample] > 0.0F; }
  double radius() const { return this->Radius; }
  /// How far from a side of the target to look whether the ball comes there: its centre cannot be
  /// nearer than the radius, and half of that is for a rough or curved side.
  double probeLength() const { return 1.5 * this->Radius; }

private:
  DistanceGrid Grid;
  std::vector<float> Field;
  double Radius;
  ScalarImage Height; ///< the field, and -Radius where the ball does not come near
};

} // namespace evolving

#endif
