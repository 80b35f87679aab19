// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Necks that have pinched off are cut.
 */

#ifndef EVOLVING_NECK_SURGERY_H
#define EVOLVING_NECK_SURGERY_H

#include "Mesh/SurfaceMesh.h"

namespace evolving
{

/**
 * Under mean curvature flow a neck becomes a point in a finite time and its sides part, which fixed
 * topology turns into a thread between them. A neck is a closed line of three short edges that is
 * no face: it is cut, and both ends are closed by a triangle (surgery, as Huisken and Sinestrari do
 * it). What is then left of a thread, components without the area of a few elements, is dropped,
 * unless it is all there is.
 *
 * @param surface of triangles. @param edgeLength edges up to half of it are short
 * @return surface itself where there is no neck
 * @throws InputError as MeshTopology
 */
SurfaceMesh withNecksCut(const SurfaceMesh& surface, double edgeLength);

} // namespace evolving

#endif
