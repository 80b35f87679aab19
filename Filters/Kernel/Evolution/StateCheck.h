// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Is the surface after a step still one?
 */

#ifndef EVOLVING_STATE_CHECK_H
#define EVOLVING_STATE_CHECK_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// A step that turns over more than this part of the faces has failed.
constexpr double LargestFlippedPart = 0.1;

/// A closed surface that has less than this part of its first area has shrunk to points.
constexpr double SmallestAreaPart = 1e-8;

/// The conditions that every state of a run must meet.
class StateCheck
{
public:
  StateCheck() = default;
  /// @param guard enlargement of the start's box that no point may leave; 0 for no box
  StateCheck(const SurfaceMesh& start, double guard);

  /**
   * @param before the points one step earlier
   * @throws SolverError that says what is wrong, when a coordinate is not finite, a point has
   * left the box, many faces have turned over, or the surface has vanished
   */
  void require(
    const SurfaceMesh& mesh, const std::vector<Vec3>& before, const Execution& execution) const;

private:
  void requireInside(const SurfaceMesh& mesh, const Execution& execution) const;

  Box Guard; ///< empty for none
  double Enlargement = 0.0;
  double StartArea = 0.0;
};

} // namespace evolving

#endif
