// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A VTK filter executed on so many threads: how long it takes, and what it complains about.
 */

#ifndef BENCHMARK_FILTER_RUN_H
#define BENCHMARK_FILTER_RUN_H

#include "Arguments.h"
#include "Timing.h"

#include <string>

class vtkAlgorithm;

namespace benchmark
{

struct FilterRun
{
  Seconds time;
  std::string error; ///< its sentence, without file, line and object; empty when all went well
};

/// Errors are kept instead of printed.
FilterRun runFilter(vtkAlgorithm* filter, const Arguments& arguments);

} // namespace benchmark

#endif
