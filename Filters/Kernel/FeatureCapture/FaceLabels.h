// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which label of the target each face of a surface lies on.
 */

#ifndef EVOLVING_FACE_LABELS_H
#define EVOLVING_FACE_LABELS_H

#include "FeatureCapture/VertexLabels.h"
#include "Features/TargetFeatures.h"
#include "Remeshing/EditableSurface.h"

namespace evolving
{

/**
 * Sets EditableSurface::label() to the label that all corners of a face share. Where they share
 * several (all lie on borders) or none (a corner of the target is near), the one that lies nearest
 * and most nearly in the face's plane, and that the faces around have.
 */
void labelFaces(
  EditableSurface& surface, const TargetFeatures& features, const VertexLabels& labels);

} // namespace evolving

#endif
