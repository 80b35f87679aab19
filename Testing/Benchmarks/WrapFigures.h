// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What an engineer sees of a wrap, in figures: its ridges, normals, distances, holes and elements.
 */

#ifndef BENCHMARK_WRAP_FIGURES_H
#define BENCHMARK_WRAP_FIGURES_H

#include "Timing.h"

#include "Mesh/SurfaceMesh.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace benchmark
{

/// The headers of the columns, and what they mean.
std::vector<std::string> figureNames();
std::vector<std::string> figureNotes();

/// One for every name; not a number where there is none to be had.
using WrapFigures = std::vector<double>;

/**
 * @param surface triangles, at least one
 * @param target welded triangles, at least one
 */
WrapFigures wrapFigures(
  const evolving::SurfaceMesh& surface, vtkPolyData* target, const Seconds& time);

/// The figures of the first as texts, with a star where they are better than the other's.
std::vector<std::string> withStars(
  const WrapFigures& figures, const WrapFigures& others, vtkPolyData* target);

} // namespace benchmark

#endif
