// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Vertices move along the surface to the middle of the elements around them.
 */

#ifndef EVOLVING_RELAXATION_H
#define EVOLVING_RELAXATION_H

#include "Execution.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/ReferenceSurface.h"

#include <functional>

namespace evolving
{

/**
 * Every vertex goes `damping` of the way to the centroid of the triangles around it, each weighted
 * by its area over the squared size there, and then onto the reference; vertices on curves to the
 * middle between their neighbours on the curve. Corners, pinned and boundary vertices stay. No
 * face turns over.
 */
void relax(EditableSurface& surface, const ReferenceSurface& reference, double damping, int sweeps,
  const Execution& execution = {});

/// Every vertex goes onto the reference, guarded as in relax(). Sizes need not be set.
void land(
  EditableSurface& surface, const ReferenceSurface& reference, const Execution& execution = {});

/// Only those at points that are wanted, which may be asked from several threads.
void landWhere(EditableSurface& surface, const ReferenceSurface& reference,
  const std::function<bool(const Vec3&)>& isWanted, const Execution& execution = {});

/// The curve of a vertex between two edges of one and the same curve; NoIndex for all others.
Index curveOfVertex(const EditableSurface& surface, Index vertex);

} // namespace evolving

#endif
