// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Edges and vertices of a surface come to lie on the creases and corners of the target. The
 * folder's front.
 */

#ifndef EVOLVING_FEATURE_CAPTURE_H
#define EVOLVING_FEATURE_CAPTURE_H

#include "Execution.h"
#include "Features/TargetFeatures.h"
#include "Remeshing/EditableSurface.h"

namespace evolving
{

/**
 * Splits edges where the label of the closest point of the target changes, so that each face lies
 * on one label, and moves vertices onto the borders of the labels. Then faces have the number of
 * their patch, or FeatureReference::NoPatch beside creases that could not be captured; edges on
 * creases that of their curve; and corners are pinned. Elements are bad afterwards: remesh.
 *
 * @param surface lies on the target but for its creases, and but for excluded patches, whose faces
 *   get no patch either
 * @throws Cancelled
 */
void captureFeatures(
  EditableSurface& surface, const TargetFeatures& features, const Execution& execution = {});

} // namespace evolving

#endif
