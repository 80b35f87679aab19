// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Is a collapse good for the elements around it?
 */

#ifndef EVOLVING_COLLAPSE_CRITERIA_H
#define EVOLVING_COLLAPSE_CRITERIA_H

#include "Remeshing/EdgeLengthLimits.h"
#include "Remeshing/EditableSurface.h"
#include "Types.h"

namespace evolving
{

/// What a collapse may do to the elements around it.
struct CollapseLimits
{
  double longest = LongestPerSize; ///< new edges, relative to their size
  double leastCosine = 0.5;        ///< between a face's normals before and after
  double leastQuality = 0.3;       ///< of new faces, unless they are better than the worst before
  double deepestCut = 0.1;         ///< that a boundary may move, relative to the size
};

/// Judges the faces that change when two vertices become one, and no others.
class CollapseCriteria
{
public:
  CollapseCriteria(const EditableSurface& surface, const CollapseLimits& guards)
    : Surface(surface)
    , Guards(guards)
  {
  }

  /// May `e` become `point`, and go on as its end `kept`?
  bool accepts(Index e, Index kept, const Vec3& point) const;
  /// May the boundary run past a vertex of it straight to its neighbour `kept`?
  bool mayCut(Index vanishing, Index kept) const;

private:
  /// Of the faces that a vertex takes along.
  struct Shapes
  {
    double worstBefore = 1.0;
    double worstAfter = 1.0;
  };

  bool isShortEnough(Index u, Index kept, const Vec3& point) const;
  bool mayTurn(Index out, Index other, const Vec3& point, Shapes& shapes) const;

  const EditableSurface& Surface;
  CollapseLimits Guards;
};

} // namespace evolving

#endif
