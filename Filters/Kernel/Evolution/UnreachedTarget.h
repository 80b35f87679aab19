// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What a surface that has come to rest has left of its target.
 */

#ifndef EVOLVING_UNREACHED_TARGET_H
#define EVOLVING_UNREACHED_TARGET_H

#include "Evolution/FlowState.h"
#include "Evolution/ScalarImage.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <string>
#include <vector>

namespace evolving
{

struct UnreachedPlace
{
  Vec3 middle = Vec3::Zero();
  double width = 0.0;
};

/**
 * A flow keeps the genus and the number of components of its start. So it ends as a membrane over
 * every hole and between parts, where the pull of one side balances that of the other; and what
 * lies behind a membrane, or within the target, is not reached.
 */
struct UnreachedTarget
{
  /// Pieces of the surface that are away from the target: where they are farthest, and the diameter
  /// of the ball there that fits into the hole; the widest first.
  std::vector<UnreachedPlace> membranes;
  /// Connected pieces of the target that are away from the surface: a point of them near their
  /// middle, and the diagonal of their box; the largest first. None is shorter
  /// than twice AwayFrom::surface, which elements do not show.
  std::vector<UnreachedPlace> pieces;
  double part = 0.0; ///< of the target's area that these pieces are

  bool isNothing() const { return this->membranes.empty() && this->pieces.empty(); }
};

/// From which distance on something is away, and not only between samples or edges.
struct AwayFrom
{
  double target = 0.0;  ///< a vertex of the surface from the target: a cell of the distance
  double surface = 0.0; ///< the target from the surface: two cells, or a longer edge of it
};
AwayFrom awayFrom(const ScalarImage& distance, const SurfaceMesh& surface);

/**
 * @param distance from the target, signed or not
 * @param surface triangles or polygons
 * @throws Cancelled
 */
UnreachedTarget findUnreachedTarget(const ScalarImage& distance, const SurfaceMesh& surface,
  const AwayFrom& away, const Execution& execution = {});

/**
 * Has a flow come to rest, or had the time in which the advection alone brings the farthest point
 * within the tolerance, exp(-C t) of its distance? What is not there by then will not be.
 * @param farthest distance of the start's points
 * @param advectionSpeed C of (3.8), per time
 */
bool shouldHaveArrived(
  const FlowState& state, double farthest, double advectionSpeed, double tolerance);

/// One sentence: where it is, how large and what to do. Empty for nothing.
std::string inWords(const UnreachedTarget& unreached);

/**
 * All of this for the last state of a flow: nothing where it cannot have arrived yet.
 * @param farthest distance of the start's points
 * @throws Cancelled
 */
std::string unreachedInWords(const ScalarImage& distance, const FlowState& last, double farthest,
  double advectionSpeed, const Execution& execution = {});

} // namespace evolving

#endif
