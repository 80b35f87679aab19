// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * New or better elements for a surface where it is.
 */

#ifndef EVOLVING_ELEMENT_RENEWAL_H
#define EVOLVING_ELEMENT_RENEWAL_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/ReferenceSurface.h"
#include "Remeshing/Remeshing.h"

namespace evolving
{

/// Are there no small angles, and next to no edges that are too long or too short for their sizes?
/// @param mesh the surface's
bool hasGoodElements(const EditableSurface& surface, const SurfaceMesh& mesh);

/**
 * Some passes of remeshing by the sizes that are set.
 * @param levels where vertices may not be beyond, see LevelReference; null where there is no target
 * @param isThorough what is to stay, made as good as can be
 * @throws Cancelled
 */
void renewElements(EditableSurface& surface, const ReferenceSurface& reference,
  const ReferenceSurface* levels, const RemeshingOptions& options, bool isThorough,
  const Execution& execution);

/// The same elements, the vertices of those with the smallest angles moved along the surface.
/// @param surface triangles. @throws Cancelled
SurfaceMesh withWorstAnglesMoved(const SurfaceMesh& surface, const Execution& execution);

} // namespace evolving

#endif
