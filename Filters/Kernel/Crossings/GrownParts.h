// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Parts that touch, moved so that they cross.
 */

#ifndef EVOLVING_GROWN_PARTS_H
#define EVOLVING_GROWN_PARTS_H

#include "Mesh/BoxPairs.h"
#include "Mesh/SurfaceMesh.h"
#include "Mesh/SurfaceParts.h"

#include <vector>

namespace evolving
{

/**
 * Makes closed parts that meet others a little larger, each by another amount, below a millionth
 * of the diagonal: faces that lay on each other then cross, or one covers the other.
 * @param mesh triangles, outwards where closed
 * @param pairs of triangles that meet
 */
std::vector<Vec3> grownPoints(
  const SurfaceMesh& mesh, const SurfaceParts& parts, const std::vector<IndexPair>& pairs);

} // namespace evolving

#endif
