// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The closest triangle of the samples beside a surface, by drawing every triangle into the grid.
 */

#ifndef EVOLVING_SURFACE_BAND_H
#define EVOLVING_SURFACE_BAND_H

#include "Distance/MeasuredTriangle.h"
#include "Execution.h"
#include "Types.h"

#include <array>
#include <limits>
#include <vector>

namespace evolving
{

/// A grid about the origin, measured in its longest spacing.
struct UnitGrid
{
  std::array<int, 3> dimensions{ 0, 0, 0 };
  Vec3 origin = Vec3::Zero();
  Vec3 spacing = Vec3::Ones(); ///< at most 1

  GridIndex index(int i, int j, int k) const
  {
    return (GridIndex(k) * this->dimensions[1] + j) * this->dimensions[0] + i;
  }
  Vec3 point(int i, int j, int k) const
  {
    return this->origin + this->spacing.cwiseProduct(Vec3(i, j, k));
  }
};

/// The closest triangle found so far, and how far it is.
struct Nearest
{
  float distance = std::numeric_limits<float>::infinity();
  Index triangle = NoIndex;
};

/**
 * Gives every sample its closest triangle among those whose box, grown by `reach`, and whose
 * plane, thickened by it, contain the sample. All samples at most `reach` away from the surface
 * have the right one then; others may have any.
 * @param triangles in the grid's unit, in float or double
 * @param[in,out] nearest one per sample
 * @throws Cancelled
 */
template <typename Scalar>
void drawSurfaceBand(const std::vector<MeasuredTriangle<Scalar>>& triangles,
  const std::vector<Box>& triangleBoxes, const UnitGrid& grid, double reach,
  std::vector<Nearest>& nearest, const Execution& execution = {});

} // namespace evolving

#endif
