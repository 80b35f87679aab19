// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The memory of this process, from Linux's /proc.
 */

#ifndef BENCHMARK_PEAK_MEMORY_H
#define BENCHMARK_PEAK_MEMORY_H

namespace benchmark
{

/// In a process of its own, so that memory that an earlier measurement left behind does not count.
struct PeakMemory
{
  /// Forgets the peak so far and counts from what is in use now; false without such a /proc.
  bool start();
  /// Bytes by which the peak since start() exceeds what was in use then.
  double bytes() const;

private:
  double AtStart = 0.0;
};

} // namespace benchmark

#endif
