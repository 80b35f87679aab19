// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A mesh whose triangles run through each other, cut along those lines.
 */

#ifndef EVOLVING_CUT_TRIANGLES_H
#define EVOLVING_CUT_TRIANGLES_H

#include "Execution.h"
#include "Mesh/BoxPairs.h"
#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <optional>
#include <vector>

namespace evolving
{

struct CutTriangles
{
  SurfaceMesh mesh;           ///< triangles, welded
  std::vector<Index> oldFace; ///< of each the one that it is a piece of
  /// Of old faces, not 0 where all that crosses one is a line of edges in it and in the other.
  std::vector<char> isFullyCut;
};

/**
 * The arrangement of the triangles (Zhou, Grinspun, Zorin, Jacobson, Mesh Arrangements for Solid
 * Geometry, 2016), in rounded numbers: pieces meet in whole edges, four at most edges where two
 * triangles cross. Pairs that only touch or lie on each other are left as they are, and so are
 * those that rounding would make cross once more.
 * @param mesh triangles, welded
 * @param pairs of triangles that may cross, sorted: selfIntersections()
 * @param[out] areTooMany do so many cross that it would take minutes? May be null
 * @return none where no two cross, or too many
 * @throws Cancelled
 */
std::optional<CutTriangles> cutCrossings(const SurfaceMesh& mesh,
  const std::vector<IndexPair>& pairs, const Execution& execution = {}, bool* areTooMany = nullptr);

} // namespace evolving

#endif
