// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What shrink-wrapping has to know of its target: the surface to lie on, the distance to it, and
 * the lengths that follow.
 */

#ifndef EVOLVING_WRAP_TARGET_H
#define EVOLVING_WRAP_TARGET_H

#include "Distance/DistanceGrid.h"
#include "Execution.h"
#include "Features/CreaseSizes.h"
#include "Mesh/SurfaceMesh.h"
#include "Remeshing/EditableSurface.h"
#include "ShrinkWrap/ShrinkWrapOptions.h"
#include "ShrinkWrap/WrapTuning.h"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace evolving
{

/// How small elements, and the cells that they start from, are to be.
struct WrapResolution
{
  std::array<int, 3> samples = { 128, 128, 128 };
  double edgeLength = 0.0; ///< 0 = defaultEdgeLength() of the target
  /// Shorter ones beside creases; null where all are alike.
  std::shared_ptr<const CreaseSizes> beside = nullptr;
};

struct WrapTarget
{
  Box box;                 ///< of the input
  SurfaceMesh surface;     ///< triangles: the input's, and caps on its holes
  DistanceGrid grid;       ///< with room for the start surface
  double area = 0.0;       ///< of the surface
  double edgeLength = 0.0; ///< of the result, where nothing asks for a shorter one
  std::shared_ptr<const CreaseSizes> besideCreases; ///< shorter ones there; may be null
  double offset = 0.0;                              ///< of the result from the surface
  double wall = 0.0;       ///< half the thickness of what becomes of sheets
  double startLevel = 0.0; ///< of the start from the surface
  WrapTuning tuning;

  double shortestElement() const { return this->tuning.finish.shortening * this->shortestEdge(); }
  /// Half of a wall's thickness if the smallest elements were to cover them: what is thicker is no
  /// sheet.
  double thinnestWall() const { return this->wall * this->shortestEdge() / this->edgeLength; }
  /// Half of the thickness of walls for edges of a length.
  double wallFor(double edge) const
  {
    return std::min(
      this->tuning.target.wallPerEdge * edge, this->tuning.target.largestWall * this->modelSize());
  }
  double cellSize() const { return this->grid.spacing.maxCoeff(); }
  /// The size of elements that makes remeshing end with edges of edgeLength.
  double elementSize() const { return this->tuning.finish.shortening * this->edgeLength; }
  /// The same at a point, where elements beside creases are smaller.
  double elementSizeAt(const Vec3& point) const
  {
    return this->besideCreases ? this->tuning.finish.shortening * this->besideCreases->at(point)
                               : this->elementSize();
  }
  /// Of all edges of the result.
  double shortestEdge() const
  {
    return this->besideCreases ? this->besideCreases->smallest() : this->edgeLength;
  }
  /// The diagonal of the box that the result should fill.
  double modelSize() const
  {
    return (this->box.sizes() + Vec3::Constant(2.0 * this->offset)).norm();
  }
};

/// Values at the samples of the target's grid: large, and soon of no more use.
struct TargetFields
{
  std::vector<float> distance; ///< from the surface, without sign
  std::vector<bool> isInside;  ///< as far as the target lets tell its sides
  std::vector<float> start; ///< zero on the start surface, gaps closed, negative towards the target
};

struct DescribedTarget
{
  WrapTarget target;
  TargetFields fields;
};

/// Sizes at the vertices of a surface on or around a target.
void setSizesAround(EditableSurface& surface, const WrapTarget& target);

/**
 * @param mesh triangles in any state, or points only; not empty
 * @throws InputError for a target without extent or area, coordinates that are not finite, or
 * options out of range
 * @throws Cancelled
 */
DescribedTarget describeTarget(const SurfaceMesh& mesh, const ShrinkWrapOptions& options,
  const WrapResolution& resolution, const Execution& execution, const WrapTuning& tuning = {});

} // namespace evolving

#endif
