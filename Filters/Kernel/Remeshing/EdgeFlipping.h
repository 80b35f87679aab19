// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Edges that turn to join the apexes of their two faces, for better valences or angles.
 */

#ifndef EVOLVING_EDGE_FLIPPING_H
#define EVOLVING_EDGE_FLIPPING_H

#include "Remeshing/EditableSurface.h"
#include "Types.h"

namespace evolving
{

/**
 * Flips edges where that brings the valences around nearer to 6 (4 at the boundary), but not where
 * the faces would bend more than a right fold of 37 degrees or their smallest angle would halve.
 * @return the number of flips
 */
Index flipForValences(EditableSurface& surface);

/// Flips edges where that raises the smallest angle of the two faces. @return the number of flips
Index flipForAngles(EditableSurface& surface);

} // namespace evolving

#endif
