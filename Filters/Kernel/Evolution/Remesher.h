// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What a flow asks for new elements.
 */

#ifndef EVOLVING_REMESHER_H
#define EVOLVING_REMESHER_H

#include "Evolution/ScalarImage.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"

#include <optional>
#include <vector>

namespace evolving
{

/// What a remesher sees of a flow.
struct RemeshingInput
{
  const SurfaceMesh& surface; ///< after a step; components that have shrunk to points are in it
  const std::vector<Vec3>& before;     ///< its points when it got its elements
  const std::vector<double>& distance; ///< the field's value at the vertices, or empty
  bool isLast;                         ///< the flow ends here: the result is what remains
  const ScalarImage* target = nullptr; ///< the field where it is the distance from a target
};

/**
 * Gives a flow's surface new elements. Called between steps, and again when dropped states are
 * recomputed: the result may depend on the arguments only, not on earlier calls or threads.
 */
class Remesher
{
public:
  virtual ~Remesher() = default;

  /// @return the surface with new elements: oriented, 2-manifold, with positive area; nothing when
  /// it is good as it is. @throws Cancelled
  virtual std::optional<SurfaceMesh> remesh(
    const RemeshingInput& input, const Execution& execution) = 0;
};

} // namespace evolving

#endif
