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
 * A box about the corner of every vertex: half a voxel along each axis, nothing along those that
 * are fixed, and towards a part that is one voxel thin a quarter, so that half of it is left where
 * it is moved at from both sides. The last is for vertices of sheets alone: where labels meet, one
 * of them may end in a wedge, which has to become thin.
 */
class NetLimits
{
public:
  NetLimits(const MaterialGrid& grid, const InterfaceNet& net, const Execution& execution);

  /// Of a vertex's move from its corner.
  Box box(Index vertex) const;

  /**
   * Takes points back into their boxes, those of sheets along the planes through them that their
   * normals give, as far as these meet the boxes: so the surface stays where it is.
   * @param normals unit vectors, one per vertex; not read for others than those of sheets
   */
  void apply(const InterfaceNet& net, const std::vector<Vec3>& normals, std::vector<Vec3>& points,
    const Execution& execution) const;

private:
  std::vector<std::uint8_t> Fixed;
  std::vector<std::uint8_t> Thin; ///< bit 2 a: backwards along axis a, bit 2 a + 1: forwards
};

} // namespace evolving

#endif
