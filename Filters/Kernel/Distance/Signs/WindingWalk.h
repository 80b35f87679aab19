// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The winding number along a line of samples, evaluated only where it tells something new.
 */

#ifndef EVOLVING_WINDING_WALK_H
#define EVOLVING_WINDING_WALK_H

#include "Distance/DistanceGrid.h"
#include "Distance/DistanceTarget.h"
#include "Distance/Signs/OpenEdgeField.h"
#include "Distance/Signs/WindingNumber.h"
#include "Execution.h"
#include "Trees/AABBTree.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// What crossings change along a line of samples.
struct CrossingChange
{
  int surface = 0; ///< the winding number of the surface
  int caps = 0;    ///< that of the caps
};

/// The crossings of a surface and its caps.
class Crossings
{
public:
  /**
   * @param tree the surface's triangles, then those of its caps
   * @param step from one point of the line to the next
   */
  Crossings(const AABBTree& tree, Index surfaceFaces, const Vec3& first, const Vec3& step)
    : SurfaceFaces(surfaceFaces)
    , Hits(tree.hits(Ray(first, step)))
  {
  }

  /// By those between the sample asked for last, at first the line's first, and this one.
  CrossingChange changeUpTo(int sample)
  {
    CrossingChange change;
    for (; this->Next < this->Hits.size() && this->Hits[this->Next].parameter <= sample;
         ++this->Next)
    {
      const RayHit& hit = this->Hits[this->Next];
      (hit.triangle < this->SurfaceFaces ? change.surface : change.caps) +=
        hit.isFromBehind ? -1 : 1;
    }
    return change;
  }

private:
  Index SurfaceFaces;
  std::vector<RayHit> Hits;
  std::size_t Next = 0;
};

/// What every walk over samples needs.
class WindingField
{
public:
  /// @throws Cancelled
  WindingField(
    const DistanceTarget& target, const DistanceGrid& grid, const Execution& execution = {});

  /// On the line of samples through a point.
  Crossings crossings(const Vec3& first, const Vec3& step) const
  {
    return { this->Tree, this->SurfaceFaces, first + this->Beside, step };
  }
  double windingOfSurface(const Vec3& point) const { return this->Surface.at(point); }
  /// Where the rays run, so that they and it agree on the side of a cap.
  double windingOfCaps(const Vec3& point) const { return this->Caps.at(point + this->Beside); }
  const OpenEdgeField& edges() const { return this->Edges; }

private:
  WindingField(const DistanceTarget& target, const SurfaceMesh& caps, const DistanceGrid& grid,
    const Execution& execution);

  WindingNumber Surface;
  WindingNumber Caps;
  OpenEdgeField Edges;
  AABBTree Tree; ///< of the surface's triangles, then those of its caps
  Index SurfaceFaces;
  /**
   * Rays run beside the lines of samples, nearer than what is told apart: planes and edges of a
   * model, and its caps, often lie where samples do, and no ray tells the sides of a plane that it
   * runs in.
   */
  Vec3 Beside;
};

/// A sample and the way to it.
struct WindingStep
{
  Vec3 point = Vec3::Zero();
  double clearance = 0.0; ///< at the point, a lower bound
  double length = 0.0;
  CrossingChange change; ///< by crossings on this way
};

/**
 * Carries the winding number of one sample on to the next as long as that tells the side. Where it
 * does not, the caps tell it at less cost: surface and caps together have a whole winding number,
 * which crossings carry on without loss.
 */
class WindingWalk
{
public:
  explicit WindingWalk(const WindingField& field)
    : Field(&field)
  {
  }

  /// A point is inside where the winding number is above the threshold.
  bool isInside(const WindingStep& way);

private:
  void carry(const WindingStep& way);
  bool isInDoubt() const;
  /// From the winding number of the surface, which was evaluated here.
  void findWhole(const Vec3& point);

  const WindingField* Field;
  double LastClearance = 0.0;
  double ToEdges = 0.0; ///< a lower bound for the distance
  double ToEdgesWhenMeasured = 0.0;
  double Winding = 0.0;    ///< of the last sample
  double Drift = 0.0;      ///< what it may be off by
  double Whole = 0.0;      ///< of surface and caps at the last sample
  bool KnowsWhole = false; ///< the line above is true
};

} // namespace evolving

#endif
