// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How near curves of a target's creases are to each other.
 */

#ifndef EVOLVING_CURVE_PROXIMITY_H
#define EVOLVING_CURVE_PROXIMITY_H

#include "Features/FeatureCurves.h"
#include "Features/PolylineTree.h"
#include "Features/SharpEdges.h"
#include "Features/SurfacePatches.h"
#include "Features/TargetTriangles.h"
#include "Types.h"

namespace evolving
{

/**
 * Other curves count where they are at the same patch, so not across a wall's thickness, and not
 * where two curves that meet in a corner are near because of that: within 2.67 of the distance in
 * question from it, as they are where they meet at more than 22 degrees.
 */
class CurveProximity
{
public:
  /// @param sharp may lose edges later: those do not count any more
  CurveProximity(const TargetTriangles& target, const SharpEdges& sharp);

  const FeatureCurves& network() const { return this->Network; }
  /// Is another curve than that of an edge within a distance of a point of the edge?
  bool hasOtherNear(Index edge, const Vec3& point, double distance) const;
  /// The distance of the nearest other curve from a point of an edge; infinite beyond a reach.
  double distanceToOther(Index edge, const Vec3& point, double reach) const;

private:
  /// Is it a crease of another curve?
  bool isOther(Index edge, Index other) const;
  bool isNearSharedCorner(Index c, Index d, const Vec3& point, double distance) const;
  bool sharePatch(Index edgeA, Index edgeB) const;

  const TargetTriangles& Target;
  const SharpEdges& Sharp;
  FeatureCurves Network;
  TriangleLabels Patches;
  PolylineTree Tree;
};

} // namespace evolving

#endif
