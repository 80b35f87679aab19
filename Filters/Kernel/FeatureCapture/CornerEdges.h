// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Edges that join corners of the target to the creases that end there.
 */

#ifndef EVOLVING_CORNER_EDGES_H
#define EVOLVING_CORNER_EDGES_H

#include "FeatureCapture/VertexLabels.h"
#include "Features/TargetFeatures.h"
#include "Remeshing/EditableSurface.h"

namespace evolving
{

/**
 * The vertex that a corner has taken may lie inside one label, on whose side the corner is blunt,
 * with the others behind an edge that passes the corner. Such edges flip, until on every border
 * that ends at a corner there is a vertex next to it.
 */
void joinCorners(
  EditableSurface& surface, const TargetFeatures& features, const VertexLabels& labels);

} // namespace evolving

#endif
