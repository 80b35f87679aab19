// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What the kernel needs of its host: threads, progress and a way to stop.
 *
 * The kernel owns no threads and knows no user interface; a host (a filter, a test) hands both in.
 * Loops are cut into chunks of a fixed grain and sums add partial sums in chunk order: any threads
 * in any order give the same bits. A body may throw: the loop throws, on the calling thread and
 * when all threads are done, what its first chunk that throws has thrown; later ones may not run.
 */

#ifndef EVOLVING_EXECUTION_H
#define EVOLVING_EXECUTION_H

#include <cstdint>
#include <functional>

namespace evolving
{

class Execution
{
public:
  /// Runs task(0), ..., task(count - 1), in any order, on any threads, and waits for all.
  using ParallelFor =
    std::function<void(std::int64_t count, const std::function<void(std::int64_t)>& task)>;
  /// Told the finished fraction in [0, 1], from the thread that called the kernel.
  using Progress = std::function<void(double fraction)>;
  /// Asked, from the thread that called the kernel, whether to stop.
  using StopRequest = std::function<bool()>;
  /// Works on the half-open range [begin, end).
  using RangeBody = std::function<void(std::int64_t begin, std::int64_t end)>;
  /// Sums over the half-open range [begin, end).
  using RangeSum = std::function<double(std::int64_t begin, std::int64_t end)>;

  /// Loops over mesh vertices and faces: small enough to balance, large enough to pay.
  static constexpr std::int64_t MeshGrain = 1024;

  /// Serial, silent, never stopped.
  Execution();
  Execution(ParallelFor parallelFor, Progress progress, StopRequest stopRequest);

  /// Calls body on [0, count) in chunks that begin at multiples of grain.
  void forRange(std::int64_t count, std::int64_t grain, const RangeBody& body) const;

  /**
   * As forRange, but in batches of chunks, with progress from 0 to 1 and a look at the stop
   * request between them. For loops that may last longer than half a second. A chunk should take
   * a few milliseconds at most: where chunks take longer than a batch, they run one by one.
   * @throws Cancelled
   */
  void forRangeReporting(std::int64_t count, std::int64_t grain, const RangeBody& body) const;

  /// The sum of sum(begin, end) over [0, count), the same bits for any number of threads.
  double sumRange(std::int64_t count, std::int64_t grain, const RangeSum& sum) const;

  /**
   * Tells the host the finished fraction of the current phase, and stops when it asks for that.
   * @throws Cancelled
   */
  void report(double fraction) const;

  /// An execution whose fractions 0 to 1 are this one's `from` to `to`.
  Execution phase(double from, double to) const;

private:
  ParallelFor Parallel;
  Progress Report;
  StopRequest Stop;
  double From = 0.0;
  double To = 1.0;
};

} // namespace evolving

#endif
