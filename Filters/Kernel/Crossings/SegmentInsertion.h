// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Segments as edges of a triangulation.
 */

#ifndef EVOLVING_SEGMENT_INSERTION_H
#define EVOLVING_SEGMENT_INSERTION_H

#include "Crossings/GridTriangulation.h"
#include "Types.h"

namespace evolving
{

/**
 * Makes edges of the segment between two vertices, several where it runs through others, by flips
 * of what crosses it (Sloan 1993), and fixes them.
 * @return false where it would cross a fixed edge: it ends at the vertex before that
 */
bool insertSegment(GridTriangulation& cells, Index from, Index to);

} // namespace evolving

#endif
