// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Sheets as solids of some thickness.
 */

#ifndef EVOLVING_SOLID_SHEETS_H
#define EVOLVING_SOLID_SHEETS_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <functional>
#include <optional>

namespace evolving
{

/**
 * Gives open parts two sides and a rim: a rim has creases then, as any other edge of a solid has.
 * Parts that have sheets in some places only, that are one-sided or not manifold, or whose sides
 * would run through each other at this thickness, stay as they are.
 * @param surface triangles, welded, turned to any side
 * @param isSheet is the surface a sheet at a point of it?
 * @param half of the thickness
 * @return none where all parts stay
 * @throws Cancelled
 */
std::optional<SurfaceMesh> solidSheets(const SurfaceMesh& surface,
  const std::function<bool(const Vec3&)>& isSheet, double half, const Execution& execution = {});

} // namespace evolving

#endif
