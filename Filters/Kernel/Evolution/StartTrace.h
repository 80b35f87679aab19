// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Where on the start surface the vertices of new elements come from.
 */

#ifndef EVOLVING_START_TRACE_H
#define EVOLVING_START_TRACE_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Trees/AABBTree.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * What is known of the start, its data, goes with the points of an evolution. New elements cut the
 * surface anew: a vertex of theirs lies on an old element, and comes from where that element comes
 * from. Places are handed on, not data, which would be smeared a little by every remeshing.
 */
class StartTrace
{
public:
  /// @throws Cancelled
  explicit StartTrace(const SurfaceMesh& start, const Execution& execution = {});

  /**
   * @param before the surface with its old elements
   * @param comesFrom for every vertex of it a point of the start
   * @param after the same surface with new elements
   * @return the same for the vertices of `after`
   * @throws Cancelled
   */
  std::vector<Vec3> carryOver(const SurfaceMesh& before, const std::vector<Vec3>& comesFrom,
    const SurfaceMesh& after, const Execution& execution = {}) const;

private:
  AABBTree Start;
};

} // namespace evolving

#endif
