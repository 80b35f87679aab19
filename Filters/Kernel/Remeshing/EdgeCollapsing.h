// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Short edges, and vertices with too few neighbours, vanish.
 */

#ifndef EVOLVING_EDGE_COLLAPSING_H
#define EVOLVING_EDGE_COLLAPSING_H

#include "Remeshing/EditableSurface.h"
#include "Types.h"

namespace evolving
{

/// What a collapse may do to the elements around it.
struct CollapseGuards
{
  double longest = 4.0 / 3.0; ///< new edges, relative to their size
  double leastCosine = 0.5;   ///< between a face's normals before and after
  double leastQuality = 0.3;  ///< of new faces, unless they are better than the worst before
};

/**
 * Collapses edges shorter than `ratio` times the size at their ends, the relatively shortest first,
 * where the connectivity and the guards allow it. Inner vertices meet in the middle; a vertex of a
 * curve or the boundary stays on it, a corner or pinned vertex where it is.
 * @return the number of collapses
 */
Index collapseShortEdges(EditableSurface& surface, double ratio, const CollapseGuards& guards = {});

/// Collapses one edge if the connectivity and the guards allow it, as collapseShortEdges() does.
bool collapseEdge(EditableSurface& surface, Index edge, const CollapseGuards& guards = {});

/// Collapses the shortest possible edge of every inner vertex with four or fewer neighbours.
Index collapseLowValences(EditableSurface& surface, const CollapseGuards& guards = {});

} // namespace evolving

#endif
