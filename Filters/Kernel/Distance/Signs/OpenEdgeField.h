// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How fast the winding number of an open surface can change.
 */

#ifndef EVOLVING_OPEN_EDGE_FIELD_H
#define EVOLVING_OPEN_EDGE_FIELD_H

#include "Distance/DistanceGrid.h"
#include "Distance/DistanceTarget.h"
#include "Trees/AABBTree.h"
#include "Types.h"

namespace evolving
{

/**
 * Between crossings of the surface, the winding number changes only by the field of the open edges,
 * by Biot and Savart at most length / (4 pi distance^2) per unit of way.
 */
class OpenEdgeField
{
public:
  /// @param grid the spacing says which distances are told apart
  OpenEdgeField(const DistanceTarget& target, const DistanceGrid& grid);

  /// From the edges, a lower bound; infinite without edges.
  double distance(const Vec3& point) const;
  /// Per unit of way, at a distance.
  double largestChange(double distance) const { return this->Strength / (distance * distance); }

private:
  OpenEdgeField(const DistanceTarget& target, double cell);

  AABBTree Tree; ///< of points
  double Slack;
  double Strength;
};

} // namespace evolving

#endif
