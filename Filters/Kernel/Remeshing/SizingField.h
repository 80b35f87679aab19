// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How long edges should be where.
 */

#ifndef EVOLVING_SIZING_FIELD_H
#define EVOLVING_SIZING_FIELD_H

#include "Execution.h"
#include "Remeshing/EditableSurface.h"

namespace evolving
{

/// The same size at every vertex.
void setUniformSizes(EditableSurface& surface, double size);

/**
 * Sizes for which triangles stay within an error of the surface that they approximate: edges of
 * length s on a sphere of curvature k deviate from it by about k s^2 / 6, exactly s = sqrt(6 e / k
 * - 3 e^2) (Dunyach, Vanderhaeghe, Barthe, Botsch, *Adaptive Remeshing for Real-Time Mesh
 * Deformation*, 2013). The curvature of a vertex is the largest of its edges', averaged; folds at
 * creases, EditableSurface::curve(), are none.
 */
struct CurvatureSizing
{
  double smallest = 0.0;
  double largest = 0.0;
  double gradation = 0.2; ///< growth of the size per length along the surface, at most
};

/**
 * Sets sizes by curvature with the error for which about `vertices` vertices are needed.
 * @return that error, a length
 */
double setSizesForVertexCount(
  EditableSurface& surface, const CurvatureSizing& sizing, double vertices);

/// Sets sizes by curvature for a given error.
void setSizesForError(EditableSurface& surface, const CurvatureSizing& sizing, double error);

/// Lowers sizes until none exceeds a neighbour's by more than `gradation` per length (Dijkstra).
void gradeSizes(EditableSurface& surface, double gradation);

/// How many vertices the surface has when its edges are as long as their sizes say.
double expectedVertices(const EditableSurface& surface);

} // namespace evolving

#endif
