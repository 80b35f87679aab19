// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Medians of repeated measurements, and threads for calls of the kernel.
 */

#ifndef BENCHMARK_TIMING_H
#define BENCHMARK_TIMING_H

#include "Execution.h"

#include <functional>
#include <vector>

namespace benchmark
{

/// On a machine that others use, the processor's time says more than the clock's.
struct Seconds
{
  double wall = 0.0;
  double cpu = 0.0; ///< of all threads of the process
};

/// In all, after which a measurement is not repeated.
constexpr double LongSeconds = 30.0;

Seconds timed(const std::function<void()>& work);
/// Of wall and processor time, each on its own.
Seconds median(const std::vector<Seconds>& measured);
/// Fewer runs where they last: none begins after LongSeconds, for what is long varies less.
Seconds medianOf(int runs, const std::function<void()>& work);

/// Threads that take the kernel's tasks in ascending order.
evolving::Execution executionOn(int threads);

} // namespace benchmark

#endif
