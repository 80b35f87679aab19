// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Creases that cost elements too much, and how they are let go.
 */

#ifndef EVOLVING_FEATURE_RELEASE_H
#define EVOLVING_FEATURE_RELEASE_H

#include "Remeshing/EditableSurface.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * The vertices on creases at the corners of triangles with a smaller angle than some: there are
 * more creases, or they meet at a smaller angle, than elements of that size can carry.
 * @param degrees the angle
 * @param atTips the same, where it is less, for the triangles of a tip: a pinned vertex around
 * which there are less than 180 degrees in all. A tip that is let go is cut off by about an
 * element, of a crease less is lost.
 * @return ascending
 */
std::vector<Index> crampedFeatures(
  const EditableSurface& surface, double degrees, double atTips = 180.0);

/// Lets the creases go at some vertices.
void releaseFeatures(EditableSurface& surface, const std::vector<Index>& vertices);

} // namespace evolving

#endif
