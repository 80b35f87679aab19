// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * New elements for a surface: edges as long as they should be, and nearly equilateral triangles.
 */

#ifndef EVOLVING_REMESHING_H
#define EVOLVING_REMESHING_H

#include "Execution.h"
#include "Remeshing/EdgeCollapsing.h"
#include "Remeshing/EdgeLengthLimits.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/ReferenceSurface.h"

#include <cmath>

namespace evolving
{

struct RemeshingOptions
{
  double longest = LongestPerSize;   ///< edges stay, relative to their size
  double shortest = ShortestPerSize; ///< edges stay, likewise
  int relaxations = 3;               ///< after each pass
  double damping = 0.7;
  CollapseLimits guards;
  double mostVertices = HUGE_VAL; ///< on the way; what needs more is an InputError
};

/**
 * One pass: long edges are split, short ones collapsed, edges flipped for even valences, and
 * vertices relaxed along the reference (Botsch, Kobbelt, *A Remeshing Approach to Multiresolution
 * Modeling*, 2004). Sizes must be set. Unused vertices and faces are gone afterwards.
 * @throws InputError when splitting makes more than mostVertices
 */
void remeshOnce(EditableSurface& surface, const ReferenceSurface& reference,
  const RemeshingOptions& options, const Execution& execution = {});

/// A pass without new vertices: vertices of few neighbours vanish, edges flip for better angles.
void polishOnce(EditableSurface& surface, const ReferenceSurface& reference,
  const RemeshingOptions& options, const Execution& execution = {});

} // namespace evolving

#endif
