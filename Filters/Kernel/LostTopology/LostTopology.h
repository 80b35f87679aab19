// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The holes, handles, slits and parts of a target that a result has not.
 */

#ifndef EVOLVING_LOST_TOPOLOGY_H
#define EVOLVING_LOST_TOPOLOGY_H

#include "Execution.h"
#include "LostTopology/ChangedPlaces.h"
#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <optional>
#include <string>

namespace evolving
{

/// In edge lengths: elements for what is narrower would be a hundred times as many, all at once.
constexpr double LeastWidthToAskFor = 0.2;

/// What would bring the lost places back; none or 0 is not to blame.
struct LostTopologyRemedy
{
  bool isTooNarrow = false;   ///< only another input would, or asking for less
  bool isStart = false;       ///< a start that has the target's holes
  std::optional<int> samples; ///< along each axis; 0 = automatic
  double edgeLength = 0.0;
  Index points = 0; ///< instead of an edge length
};

/// Of a target, as it is seen from outside, whose genus or number of parts the result has not.
struct LostTopology
{
  Index genus = 0; ///< of all parts together
  Index parts = 0;
  Index genusOfResult = 0;
  Index partsOfResult = 0;
  /// May be none; without what is missing where the rest says it all.
  ChangedPlaces places;
  /// The width to ask for: of as many places as were lost, for others are notches that are a little
  /// rounder now, the narrowest for which elements need not be far smaller. 0 without any.
  double narrowest = 0.0;
  double area = 0.0;         ///< of the target, as it is seen
  LostTopologyRemedy remedy; ///< for who made the result to say
};

/**
 * @param target triangles, welded; only one that is closed, manifold and oriented, and does not
 * intersect itself, has a topology to lose
 * @param result triangles; likewise
 * @param edgeLength of the result
 * @return nothing where nothing was lost, or where that cannot be known
 * @throws Cancelled
 */
std::optional<LostTopology> findLostTopology(const SurfaceMesh& target, const SurfaceMesh& result,
  double edgeLength, const Execution& execution = {});

/// One sentence: what was lost, where, how large it is and what to do.
std::string inWords(const LostTopology& lost);

} // namespace evolving

#endif
