// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What a table says of a surface that stands for another: topology, elements, distance.
 */

#ifndef BENCHMARK_SURFACE_MEASURES_H
#define BENCHMARK_SURFACE_MEASURES_H

#include "Mesh/SurfaceMesh.h"

#include <string>
#include <vector>

namespace benchmark
{

/// The headers of the columns that surfaceMeasures() fills, and what they mean.
std::vector<std::string> measureNames();
std::vector<std::string> measureNotes();

/**
 * @param surface triangles, at least one
 * @param reference welded triangles, or points alone
 */
std::vector<std::string> surfaceMeasures(
  const evolving::SurfaceMesh& surface, const evolving::SurfaceMesh& reference);

} // namespace benchmark

#endif
