// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What lies inside closed parts of a surface that was cut where it crosses itself.
 */

#ifndef EVOLVING_COVERED_PIECES_H
#define EVOLVING_COVERED_PIECES_H

#include "Crossings/CutTriangles.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Mesh/SurfaceParts.h"

#include <vector>

namespace evolving
{

/**
 * By the winding number of the closed parts. What crosses nothing is covered as a whole or not at
 * all: slivers, of which rounding decides, follow the others.
 * @param whole before it was cut, outwards where closed
 * @return not 0 for pieces that are covered
 * @throws Cancelled
 */
std::vector<char> coveredPieces(const SurfaceMesh& whole, const SurfaceParts& parts,
  const CutTriangles& cut, const Execution& execution = {});

} // namespace evolving

#endif
