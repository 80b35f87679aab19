// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Short edges, and vertices with too few neighbours, vanish.
 */

#ifndef EVOLVING_EDGE_COLLAPSING_H
#define EVOLVING_EDGE_COLLAPSING_H

#include "Remeshing/CollapseCriteria.h"
#include "Remeshing/EditableSurface.h"
#include "Types.h"

namespace evolving
{

/**
 * Collapses edges shorter than `ratio` times the size at their ends, the relatively shortest first,
 * where the connectivity and the guards allow it. Inner vertices meet in the middle; a vertex of a
 * curve or the boundary stays on it, a corner, a pinned vertex or one between two curves where it
 * is.
 * @return the number of collapses
 */
Index collapseShortEdges(EditableSurface& surface, double ratio, const CollapseLimits& guards = {});

/// Collapses one edge if the connectivity and the guards allow it, as collapseShortEdges() does.
bool collapseEdge(EditableSurface& surface, Index edge, const CollapseLimits& guards = {});

/// Collapses the shortest possible edge of every inner vertex with four or fewer neighbours.
Index collapseLowValences(EditableSurface& surface, const CollapseLimits& guards = {});

} // namespace evolving

#endif
