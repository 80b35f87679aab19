// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What vtkShrinkWrap says of its result. Private to the module.
 */

#ifndef WrapReport_h
#define WrapReport_h

#include "KernelBridge.h"

#include <string>
#include <vector>

class EvolutionOutput;
class vtkPolyData;

namespace WrapReport
{

/**
 * Measures the result as it is handed out: with points as the series writes them, and the series
 * turns to doubles when floats would spoil the result.
 */
evolving::SurfaceReport Examine(const evolving::SurfaceMesh& result,
  const evolving::ShrinkWrapProblem& problem, EvolutionOutput& series,
  const evolving::Execution& execution);

/// As field data.
void Write(const evolving::SurfaceReport& report, const std::vector<std::string>& shortcomings,
  vtkPolyData* output);

} // namespace WrapReport

#endif
