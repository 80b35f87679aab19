// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The vertices of the worst elements move to where their worst angle is best.
 */

#ifndef EVOLVING_STAR_OPTIMIZATION_H
#define EVOLVING_STAR_OPTIMIZATION_H

#include "Execution.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/ReferenceSurface.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * The vertices of triangles with an angle below `degrees`, the worst first, try places around them
 * on the surface and go where the smallest angle of their triangles is larger. They keep their
 * height over the reference. Corners, pinned and boundary vertices stay, those on curves slide.
 * The outcome is that of one vertex after the other, so it does not depend on threads.
 * @param rounds over all such vertices; ends early when none is left or none moves
 * @return the vertices that moved, each counted once per round
 */
Index optimizeStars(EditableSurface& surface, const ReferenceSurface& reference, double degrees,
  int rounds, const Execution& execution = {});

/// The same for given vertices only, those of good triangles left alone.
Index optimizeStarsOf(EditableSurface& surface, const ReferenceSurface& reference,
  const std::vector<Index>& vertices, double degrees, int rounds);

} // namespace evolving

#endif
