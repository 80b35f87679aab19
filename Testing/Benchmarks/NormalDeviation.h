// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How far the faces of a surface are turned from those of the one it stands for.
 */

#ifndef BENCHMARK_NORMAL_DEVIATION_H
#define BENCHMARK_NORMAL_DEVIATION_H

#include "Mesh/SurfaceMesh.h"

namespace benchmark
{

/// Angles in degrees between a face and the reference closest to its middle, weighted by area.
struct NormalDeviation
{
  double partOver20 = 0.0; ///< of the surface's area; 0 to 1
  double rms = 0.0;
};

/**
 * Of lines, not arrows: the reference may be turned inside out. Faces without area do not count.
 * @param surface triangles, at least one
 * @param reference triangles, at least one
 */
NormalDeviation normalDeviation(
  const evolving::SurfaceMesh& surface, const evolving::SurfaceMesh& reference);

} // namespace benchmark

#endif
