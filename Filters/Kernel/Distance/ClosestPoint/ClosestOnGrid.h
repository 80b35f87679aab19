// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The closest triangle, and how far it is, of every sample of a grid: exact everywhere.
 */

#ifndef EVOLVING_CLOSEST_ON_GRID_H
#define EVOLVING_CLOSEST_ON_GRID_H

#include "Distance/DistanceGrid.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// One entry per sample.
struct GridClosest
{
  std::vector<float> distance; ///< in the grid's unit; infinity beyond the band
  std::vector<Index> triangle; ///< NoIndex there
};

/// What the search may use of the processor.
enum class Instructions
{
  Any,  ///< what every processor of the kind has
  Best, ///< what this one has
};

/**
 * Blocks of samples are searched together over a tree of oriented boxes (OrientedBoxTree,
 * BlockSearch.hxx), each in its own right: the result for a sample is the same, bit for bit,
 * whatever part of a grid is computed, by how many threads, and with whichever instruction set the
 * processor has. The distance differs from the exact one by rounding: some 1e-6 of itself and 1e-7
 * of the triangle's longest edge; within a cell and a half of the surface it is computed in double.
 *
 * @param mesh of triangles only, not none
 * @param grid a part of any grid whose sample (0, 0, 0) has the same origin
 * @param band in units of the grid; samples farther away than this may be left out
 * @throws Cancelled
 */
GridClosest closestOnGrid(const SurfaceMesh& mesh, const DistanceGrid& grid, double band,
  const Execution& execution = {}, Instructions instructions = Instructions::Best);

/// Can distances be measured in floats? Not when the mesh is some million cells large or away.
bool isWithinReachOfFloats(const SurfaceMesh& mesh, const DistanceGrid& grid);

} // namespace evolving

#endif
