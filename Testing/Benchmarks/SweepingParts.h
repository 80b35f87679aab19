// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Method FastSweeping taken apart, to time its phases (algorithm 6 of the thesis).
 */

#ifndef BENCHMARK_SWEEPING_PARTS_H
#define BENCHMARK_SWEEPING_PARTS_H

#include "Distance/DistanceGrid.h"
#include "Distance/SignedDistance.h"
#include "Distance/Sweeping/DistanceOctree.h"
#include "Distance/Sweeping/FastSweeping.h"
#include "Mesh/SurfaceMesh.h"

namespace benchmark
{

/// The cube grid that vtkMeshSDF takes by default.
evolving::DistanceGrid cubeGrid(const evolving::SurfaceMesh& mesh, int size);

/// The field before the first sweep: the octree's leaves frozen at their distance.
evolving::SweptField frozenField(
  const evolving::DistanceOctree& octree, const evolving::DistanceGrid& grid);

/// The kernel's whole computation.
evolving::SignedDistanceResult wholeDistance(const evolving::SurfaceMesh& mesh, int size,
  evolving::DistanceMethod method, evolving::SignMethod sign, const evolving::Execution& execution);

} // namespace benchmark

#endif
