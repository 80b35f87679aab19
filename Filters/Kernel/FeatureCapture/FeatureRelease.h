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

#include <algorithm>
#include <vector>

namespace evolving
{

/// The smallest angles of triangles beside creases, in degrees, that creases are worth.
struct CreaseWorth
{
  double angle = 0.0; ///< beside creases in general
  /// The same, where it is less, for the triangles of a tip: a pinned vertex around which there are
  /// less than 180 degrees in all. A tip that is let go is cut off by about an element, of a crease
  /// less is lost. So, too, for a triangle between two creases that meet at its smallest angle, in
  /// a pinned vertex: there is no better one.
  double atTips = 180.0;
  /// Of each curve, in degrees; may be empty, then they are all the same.
  std::vector<double> folds = {};

  double foldOf(Index curve) const
  {
    return at(curve) < this->folds.size() ? this->folds[at(curve)] : 180.0;
  }
};

/**
 * The triangles at creases with a smaller angle than these are worth: there are more
 * creases, or they meet at a smaller angle, than elements of that size can carry.
 * @return ascending
 */
std::vector<Index> crampedFaces(const EditableSurface& surface, const CreaseWorth& worth);

/// The vertices of some faces that are on creases, ascending.
std::vector<Index> creaseVertices(const EditableSurface& surface, const std::vector<Index>& faces);

/**
 * Lets one crease go at each of some faces, edge by edge: of two that meet at its smallest angle
 * the weaker one; else the weakest of those at its corners. The others stay, and the vertices that
 * are pinned, as long as there is one.
 */
void releaseWeakest(
  EditableSurface& surface, const std::vector<Index>& faces, const CreaseWorth& worth);

/// Lets all creases go at some vertices, and the vertices, too, but for tips around which three
/// triangles have angles that are worth it.
void releaseFeatures(
  EditableSurface& surface, const std::vector<Index>& vertices, const CreaseWorth& worth = {});

} // namespace evolving

#endif
