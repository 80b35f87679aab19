// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The genus that a result of shrink-wrapping should have.
 */

#ifndef EVOLVING_WANTED_GENUS_H
#define EVOLVING_WANTED_GENUS_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "ShrinkWrap/ShrinkWrapOptions.h"
#include "Types.h"

#include <optional>

namespace evolving
{

/// Is a target wrapped as it is? A GapSize or an OffsetDistance closes holes on purpose.
bool keepsTopology(const ShrinkWrapOptions& options);

/**
 * The genus of a target that is one closed surface, manifold, oriented and without
 * self-intersections, if it keepsTopology().
 * @param target triangles, welded
 * @throws Cancelled
 */
std::optional<Index> genusToKeep(
  const SurfaceMesh& target, const ShrinkWrapOptions& options, const Execution& execution = {});

} // namespace evolving

#endif
