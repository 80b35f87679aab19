// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Long edges get a vertex in their middle.
 */

#ifndef EVOLVING_EDGE_SPLITTING_H
#define EVOLVING_EDGE_SPLITTING_H

#include "Remeshing/EditableSurface.h"
#include "Types.h"

namespace evolving
{

/**
 * Splits every edge longer than `ratio` times the size at its ends, the relatively longest first,
 * until there is none. New vertices lie in the middle of their edges.
 * @return the number of splits
 */
Index splitLongEdges(EditableSurface& surface, double ratio);

/// The first of the sweeps of splitLongEdges(): every edge at most once.
Index halveLongEdges(EditableSurface& surface, double ratio);

} // namespace evolving

#endif
