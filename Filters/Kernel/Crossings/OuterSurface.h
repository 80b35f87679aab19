// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What is seen of parts that run through each other: one surface. The folder's front.
 */

#ifndef EVOLVING_OUTER_SURFACE_H
#define EVOLVING_OUTER_SURFACE_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"

#include <optional>

namespace evolving
{

/**
 * The triangles cut along the lines where they cross, without what lies inside closed parts: of
 * closed parts their union, whose creases are edges. Open parts that are a soup, each triangle in
 * many others, are not cut by each other. Parts that meet are moved by less than a
 * millionth of the diagonal, so that contacts are crossings (GrownParts.h).
 * @param surface triangles, welded
 * @param[out] isTangled does so much cross that it would take minutes to cut? May be null
 * @return none where nothing crosses, or too much; what only touches itself does not
 * @throws InputError when a coordinate is not finite. @throws Cancelled
 */
std::optional<SurfaceMesh> outerSurface(
  const SurfaceMesh& surface, const Execution& execution = {}, bool* isTangled = nullptr);

} // namespace evolving

#endif
