// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which sides are seen from outside, of a surface that was cut where it crosses itself.
 */

#ifndef EVOLVING_SEEN_SIDES_H
#define EVOLVING_SEEN_SIDES_H

#include "Crossings/CutTriangles.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Mesh/SurfaceParts.h"

#include <vector>

namespace evolving
{

/// Which side of a piece is outside of all closed parts.
enum class SeenSide : char
{
  None,
  Front,
  Back ///< of a closed part that is turned inside out there
};

/**
 * By the winding number of the closed parts, inside is where it is not zero. It is asked once for
 * each region: pieces that are connected across edges of two. A piece of a triangle that was not
 * cut where it should be is a region of its own, covered only if all of it is; where its winding
 * number is in doubt, as that of slivers and of faces on each other, it follows the others of its
 * patch.
 * @param whole before it was cut, outwards where closed
 * @return of each piece; of open parts no back
 * @throws Cancelled
 */
std::vector<SeenSide> seenSides(const SurfaceMesh& whole, const SurfaceParts& parts,
  const CutTriangles& cut, const Execution& execution = {});

} // namespace evolving

#endif
