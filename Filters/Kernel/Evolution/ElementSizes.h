// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How large the elements of an evolving surface shall be where.
 */

#ifndef EVOLVING_ELEMENT_SIZES_H
#define EVOLVING_ELEMENT_SIZES_H

#include "Remeshing/EditableSurface.h"

namespace evolving
{

enum class ElementSizing
{
  Uniform = 1,
  CurvatureAdaptive = 2, ///< about as many as uniform ones, smaller where the surface is curved
};

/**
 * Sets the sizes of a surface whose edges shall have a length in the mean. A component has at
 * least some hundred vertices, however small it is, but ten thousand are enough for many components
 * together. Needles, which have a length but next to no area, have no more.
 * @param surface without unused vertices
 * @param mostVertices that may be made
 * @throws InputError as requireFewVertices()
 */
void setElementSizes(
  EditableSurface& surface, double edgeLength, ElementSizing sizing, double mostVertices);

} // namespace evolving

#endif
