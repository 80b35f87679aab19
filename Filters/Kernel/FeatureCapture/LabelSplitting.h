// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * New vertices where edges of a surface pass from one label of the target to another.
 */

#ifndef EVOLVING_LABEL_SPLITTING_H
#define EVOLVING_LABEL_SPLITTING_H

#include "FeatureCapture/VertexLabels.h"
#include "Features/TargetFeatures.h"
#include "Remeshing/EditableSurface.h"

namespace evolving
{

/**
 * Splits edges whose ends have no label in common, where the label of the closest point changes;
 * the new vertex goes onto the border of the two labels. Afterwards most faces have a label that
 * all their corners share. Edges between held vertices stay whole.
 */
void splitLabelChanges(
  EditableSurface& surface, const TargetFeatures& features, VertexLabels& labels);

} // namespace evolving

#endif
