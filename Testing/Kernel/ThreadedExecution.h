// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The host that is hardest on the kernel: real threads that take tasks in shuffled order.
 */

#ifndef EVOLVING_THREADED_EXECUTION_H
#define EVOLVING_THREADED_EXECUTION_H

#include "Execution.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <random>
#include <thread>
#include <vector>

namespace evolving
{

/// Results must have the same bits for every number of threads and every seed.
inline Execution threadedExecution(int threads, unsigned seed)
{
  const auto parallelFor = [threads, seed](
                             std::int64_t count, const std::function<void(std::int64_t)>& task)
  {
    std::vector<std::int64_t> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    std::atomic<std::size_t> next{ 0 };
    const auto work = [&]
    {
      for (std::size_t i = next++; i < order.size(); i = next++)
      {
        task(order[i]);
      }
    };
    std::vector<std::thread> pool;
    for (int t = 1; t < threads; ++t)
    {
      pool.emplace_back(work);
    }
    work();
    for (std::thread& thread : pool)
    {
      thread.join();
    }
  };
  return Execution(parallelFor, nullptr, nullptr);
}

} // namespace evolving

#endif
