// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The simplest way to make elements even, to compare with: points go towards the mean of their
 * neighbours and back to the surface. Nothing keeps sharp edges, nor elements from turning over.
 */

#ifndef BENCHMARK_UMBRELLA_SMOOTHING_H
#define BENCHMARK_UMBRELLA_SMOOTHING_H

#include "Mesh/SurfaceMesh.h"
#include "Trees/AABBTree.h"

namespace benchmark
{

struct UmbrellaSmoothing
{
  int iterations = 100;
  double factor = 0.5;     ///< of the way to the mean of the neighbours
  bool tangential = false; ///< only along the surface
};

/**
 * Boundary points stay.
 * @param surface whose closest points the moved ones go back to
 * @throws evolving::InputError for a mesh that is no oriented manifold
 */
evolving::SurfaceMesh smoothed(const evolving::SurfaceMesh& mesh, const evolving::AABBTree& surface,
  const UmbrellaSmoothing& smoothing);

} // namespace benchmark

#endif
