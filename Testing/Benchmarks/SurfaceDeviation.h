// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How far a surface lies from the one it stands for, both ways.
 */

#ifndef BENCHMARK_SURFACE_DEVIATION_H
#define BENCHMARK_SURFACE_DEVIATION_H

#include "Mesh/SurfaceMesh.h"

namespace benchmark
{

/// Over the points of one side and 50,000 drawn evenly from its faces.
struct Distances
{
  double rms = 0.0;
  double largest = 0.0;
};

/// As fractions of the diagonal of the reference's box.
struct SurfaceDeviation
{
  Distances forward;  ///< of the surface from the reference
  Distances backward; ///< of the reference from the surface; of a point set, all of its points

  double hausdorff() const;
};

/**
 * The points drawn are the same in every run.
 * @param surface triangles, at least one
 * @param reference triangles, or points alone; both use every point
 */
SurfaceDeviation deviation(
  const evolving::SurfaceMesh& surface, const evolving::SurfaceMesh& reference);

} // namespace benchmark

#endif
