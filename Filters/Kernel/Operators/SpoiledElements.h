// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which elements a move of their points would spoil.
 */

#ifndef EVOLVING_SPOILED_ELEMENTS_H
#define EVOLVING_SPOILED_ELEMENTS_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving
{

/**
 * Says which elements moves spoil, and whose.
 *
 * A move spoils an element when a corner that was convex, seen along the element's normal before
 * the move, is not after it; when the element showed the side that its vertices show, and does not
 * any more (so that none turns over step by step); or when its smallest angle drops and is below
 * smallestAngle.
 */
class SpoiledElements
{
public:
  /**
   * @param mesh at the points after the move
   * @param before the points before it
   * @param normals of the vertices before it
   * @param smallestAngle in degrees; 0: any will do. All are referred to, not copied
   */
  SpoiledElements(const SurfaceMesh& mesh, const std::vector<Vec3>& before,
    const std::vector<Vec3>& normals, double smallestAngle);

  /// Is the face spoiled when all its corners move?
  bool isSpoiled(Index face) const;
  /// Is it when its k-th corner moves and the others rest?
  bool isSpoiledBy(Index face, Index k) const;

private:
  const SurfaceMesh& Mesh;
  const std::vector<Vec3>& Before;
  const std::vector<Vec3>& Normals;
  double LargestCotangent;
};

/// SpoiledElements::isSpoiled() of every face, one flag each.
std::vector<char> spoiledElements(const SurfaceMesh& mesh, const std::vector<Vec3>& before,
  const std::vector<Vec3>& normals, double smallestAngle, const Execution& execution);

} // namespace evolving

#endif
