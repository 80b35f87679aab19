// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Makes ridges that lie on no crease of the target go straight on, or round: no saw teeth.
 */

#ifndef EVOLVING_RIDGE_FAIRING_H
#define EVOLVING_RIDGE_FAIRING_H

#include "Execution.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/ReferenceSurface.h"

namespace evolving
{

/// Angles in degrees.
struct RidgeFairingOptions
{
  double sharpFold = 30.0;  ///< between two faces of a ridge, at least
  double sharpTurn = 40.0;  ///< a ridge goes on where another one turns by less
  double farthest = 0.5;    ///< that a vertex may go, in sizes
  double leastAngle = 30.0; ///< of triangles; smaller ones do not get smaller
  int rounds = 12;
};

/**
 * Where an edge of the mesh crosses a crease instead of lying on it, faces fold to and fro along
 * it. An edge of a fold that ends in another direction at one of its ends is such a tooth. Its
 * ends, and the vertices around them, go half the way to the middle of their neighbours, again and
 * again, until the fold goes on straight or is none any more. Vertices on curves, at the boundary,
 * and pinned ones stay; a fold that ends at the boundary, in a corner of curves or in a pinned
 * vertex is no tooth. No vertex goes where the faces around it would turn away from the reference,
 * or get too small angles.
 * @return the number of vertices that have moved
 * @throws Cancelled
 */
Index fairRidges(EditableSurface& surface, const ReferenceSurface& reference,
  const RidgeFairingOptions& options = {}, const Execution& execution = {});

} // namespace evolving

#endif
