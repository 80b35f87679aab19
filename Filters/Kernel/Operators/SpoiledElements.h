// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which elements a move of their points would spoil.
 */

#ifndef EVOLVING_SPOILED_ELEMENTS_H
#define EVOLVING_SPOILED_ELEMENTS_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving
{

/**
 * A move spoils an element when a corner that was convex, seen along the element's normal before
 * the move, is not after it; when the element showed the side that its vertices show, and does not
 * any more (so that none turns over step by step); or when its smallest angle drops and is below
 * smallestAngle.
 * @param mesh at the points after the move
 * @param before the points before it
 * @param normals of the vertices before it
 * @param smallestAngle in degrees; 0: any will do
 * @return one flag per face
 */
std::vector<char> spoiledElements(const SurfaceMesh& mesh, const std::vector<Vec3>& before,
  const std::vector<Vec3>& normals, double smallestAngle, const Execution& execution);

} // namespace evolving

#endif
