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

using FacePair = std::pair<Index, Index>;
using FacePairs = std::vector<FacePair>;

/**
 * Takes the vertices of intersecting triangles, unless they are pinned or on feature edges, to
 * the middle of their neighbours, some times over. Where that does not help, creases that hold
 * them are let go, with the labels beside them. Places where many intersect are left alone.
 * @param surface is compact
 * @param pairs the intersecting triangles
 * @return those that intersect afterwards
 * @throws Cancelled
 */
FacePairs untangle(EditableSurface& surface, FacePairs pairs, const Execution& execution = {});

} // namespace evolving

#endif
