// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Small places where a surface runs through itself.
 */

#ifndef EVOLVING_UNTANGLING_H
#define EVOLVING_UNTANGLING_H

#include "Execution.h"
#include "Remeshing/EditableSurface.h"
#include "Types.h"

#include <utility>
#include <vector>

namespace evolving
{

/**
 * Takes the vertices of intersecting triangles, unless they are pinned or on feature edges, to
 * the middle of their neighbours, some times over; where many intersect it does not try.
 * @param surface is compact
 * @param pairs the intersecting triangles
 * @return whether nothing intersects any more
 * @throws Cancelled
 */
bool untangle(EditableSurface& surface, std::vector<std::pair<Index, Index>> pairs,
  const Execution& execution = {});

} // namespace evolving

#endif
