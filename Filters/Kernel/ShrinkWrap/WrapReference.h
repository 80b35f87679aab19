// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Where the result of shrink-wrapping is to lie.
 */

#ifndef EVOLVING_WRAP_REFERENCE_H
#define EVOLVING_WRAP_REFERENCE_H

#include "Execution.h"
#include "Remeshing/ReferenceSurface.h"
#include "ShrinkWrap/OuterRegion.h"
#include "ShrinkWrap/WrapLevels.h"
#include "ShrinkWrap/WrapTarget.h"
#include "Trees/AABBTree.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace evolving
{

/**
 * The target, or the surface at a distance around it. Sheets that can be reached from both sides
 * become walls: two layers of triangles on one sheet would fold through each other. Points farther
 * away than two edge lengths have no place there: membranes across holes stay where they are.
 */
class WrapReference : public ReferenceSurface
{
public:
  /// @param region of the target. @throws Cancelled
  WrapReference(
    const WrapTarget& target, const OuterRegion& region, const Execution& execution = {});

  Foot onSurface(const Vec3& point, const Vec3& facing, Index label, Index guess) const override;

  /// How far a point is from where the result is to lie next to it.
  double deviation(const Vec3& point) const;
  /// Is the closest place of the target a sheet that becomes a wall?
  bool isAtSheet(const Vec3& point) const;
  /// Is there a sheet that can be reached from both sides?
  bool hasSheets() const { return this->HasSheets; }
  /// Does the result lie at a distance from the target, everywhere?
  bool hasOffset() const { return this->Offset > 0.0; }
  /// Does the result lie on the target everywhere?
  bool isOnTarget() const { return !this->hasOffset() && !this->HasSheets; }

  /// How far from the target the result lies at most where it is to lie.
  double highestLevel() const
  {
    return this->HasSheets ? std::max(this->Offset, this->Wall) : this->Offset;
  }
  /// The area of the sheets that become walls, one side of it.
  double sheetArea() const { return this->SheetArea; }
  /// The part of the target that can be reached from outside.
  const SurfaceMesh& visible() const { return this->Visible; }
  /// About what it holds in memory.
  std::size_t bytes() const;

private:
  void findSheets(const Execution& execution);
  Foot onVisible(const Vec3& point, const Vec3& facing, Index guess) const;
  /// The point, or one at their level next to it where sheets are nearer than that.
  Vec3 awayFromSheets(const Vec3& point) const;
  double levelAt(Index triangle, const Vec3& point) const;

  SurfaceMesh Visible;
  AABBTree Tree; ///< of the levels' triangles
  WrapLevels Levels;
  double Offset;
  double Wall;
  double Reach;
  bool HasSheets = false;
  double SheetArea = 0.0;
  std::unique_ptr<AABBTree> Sheets;
  std::vector<Index> SheetNumbers; ///< in Tree
};

} // namespace evolving

#endif
