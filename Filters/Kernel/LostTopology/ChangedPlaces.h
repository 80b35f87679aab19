// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Where one solid fills what another one leaves open, or is missing where that one is.
 */

#ifndef EVOLVING_CHANGED_PLACES_H
#define EVOLVING_CHANGED_PLACES_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace evolving
{

/// A hole, a slit or the space between two parts; or a handle, a wall or a bar.
struct ChangedPlace
{
  Vec3 middle = Vec3::Zero(); ///< in the hole or the bar
  double width = 0.0;         ///< across the narrowest part that was left
};

struct ChangedPlaces
{
  std::vector<ChangedPlace> filled;  ///< what was open, the widest first
  std::vector<ChangedPlace> missing; ///< what was solid, without whole parts, the widest first
  /// Connected parts of which nothing is left: the middle and the diagonal of their boxes.
  std::vector<ChangedPlace> missingParts;
};

/**
 * Looks from places of the solid's surface to the next surface in front of them and behind them.
 * The middle of the way belongs to the open, or to the solid; where it does so no longer in the
 * result the place has changed. So no length decides what counts: an element may lie half a hole's
 * width beside its place, and the hole is still there.
 * @param solid triangles, closed, outwards, that do not intersect themselves, as outerParts() are
 * @param result triangles, closed
 * @param spacing of the places on large triangles; every triangle has one
 * @param enoughFilled places: from so many on, what is missing is not looked for
 * @throws Cancelled
 */
ChangedPlaces findChangedPlaces(const SurfaceMesh& solid, const SurfaceMesh& result, double spacing,
  std::size_t enoughFilled = std::numeric_limits<std::size_t>::max(),
  const Execution& execution = {});

} // namespace evolving

#endif
