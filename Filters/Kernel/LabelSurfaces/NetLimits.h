// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How far the vertices of a net may move.
 */

#ifndef EVOLVING_NET_LIMITS_H
#define EVOLVING_NET_LIMITS_H

#include "Execution.h"
#include "LabelSurfaces/InterfaceNet.h"
#include "LabelSurfaces/MaterialGrid.h"
#include "Types.h"

#include <cstdint>
#include <vector>

namespace evolving
{

/**
 * Vertices of sheets have a box about their corner of voxels: half a voxel along each axis, nothing
 * along those that are fixed, and towards a part that is one voxel thin a quarter, so that half of
 * it is left where it is moved at from both sides. Vertices of the curves where sheets meet, and
 * those of sheets beside them, may slide: they stay within half a voxel, along each axis, of the
 * voxels' faces of every sheet that they are in, wherever those are.
 */
class NetLimits
{
public:
  /// @param grid must outlive the limits
  NetLimits(const MaterialGrid& grid, const InterfaceNet& net, const Execution& execution);

  /// The place nearest to a vertex's corner, or nearly so, on the way to a point that is too far.
  Vec3 limited(const InterfaceNet& net, Index vertex, const Vec3& point) const;

  /**
   * Takes points back to where they may be, those of sheets along the planes through them that
   * their normals give, as far as these meet the boxes: so the surface stays where it is.
   * @param normals unit vectors, one per vertex; not read for others than those of sheets
   */
  void apply(const InterfaceNet& net, const std::vector<Vec3>& normals, std::vector<Vec3>& points,
    const Execution& execution) const;

  /// Is a vertex one of a curve within the image, or some edges from one at most, and none of a
  /// part of few voxels?
  bool isNearCurve(Index vertex) const { return this->Near[at(vertex)] != 0; }
  /// May it leave its box?
  bool slides(Index vertex) const { return this->Slides[at(vertex)] != 0; }
  void keepInBox(Index vertex) { this->Slides[at(vertex)] = 0; }
  bool isAllowed(const InterfaceNet& net, Index vertex, const Vec3& point) const;

private:
  Box box(Index vertex) const;

  const MaterialGrid& Grid;
  std::vector<std::uint8_t> Fixed;
  std::vector<std::uint8_t> Thin; ///< bit 2 a: backwards along axis a, bit 2 a + 1: forwards
  std::vector<char> Near;
  std::vector<char> Slides;
};

} // namespace evolving

#endif
