// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Where a sheet goes beyond its end: a quadric through its points, by weighted least squares.
 */

#ifndef EVOLVING_SHEET_FIT_H
#define EVOLVING_SHEET_FIT_H

#include "Types.h"

#include <optional>
#include <vector>

namespace evolving
{

/// The plane that touches a sheet beside a place: at `offset` along `normal` from it.
struct SheetPlane
{
  Vec3 normal;
  double offset = 0.0;
  double weight = 0.0; ///< 1 where some points at least say where it is, less otherwise
};

/**
 * The quadric z(u, v) over the plane across `normal` that is nearest to points, which count by a
 * Gaussian of their distances from the place; a plane where there are too few for a quadric.
 * @param normal of the sheet, roughly, a unit vector
 * @param radius of the Gaussian
 * @return nothing where there are less than three points
 */
std::optional<SheetPlane> fitSheet(
  const std::vector<Vec3>& points, const Vec3& place, const Vec3& normal, double radius);

} // namespace evolving

#endif
