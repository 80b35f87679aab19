// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Vertices that move all at once, without turning a face over.
 */

#ifndef EVOLVING_INVERSION_FREE_MOVE_H
#define EVOLVING_INVERSION_FREE_MOVE_H

#include "Execution.h"
#include "Remeshing/EditableSurface.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * Moves every vertex to its new point; those of faces whose normals would turn by more than 75
 * degrees stay where they are, and then those whose faces turn for that, until none does.
 * @param points one per vertex slot
 * @return the number of vertices that stayed
 */
Index moveWithoutInversion(
  EditableSurface& surface, const std::vector<Vec3>& points, const Execution& execution = {});

} // namespace evolving

#endif
