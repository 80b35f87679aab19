// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Timing.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <thread>

namespace benchmark
{

namespace
{

double middle(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

} // namespace

Seconds timed(const std::function<void()>& work)
{
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const std::clock_t cpuStart = std::clock();
  work();
  const std::clock_t cpuEnd = std::clock();
  const std::chrono::duration<double> wall = Clock::now() - start;
  return { wall.count(), static_cast<double>(cpuEnd - cpuStart) / CLOCKS_PER_SEC };
}

Seconds median(const std::vector<Seconds>& measured)
{
  std::vector<double> wall;
  std::vector<double> cpu;
  for (const Seconds& seconds : measured)
  {
    wall.push_back(seconds.wall);
    cpu.push_back(seconds.cpu);
  }
  return { middle(wall), middle(cpu) };
}

Seconds medianOf(int runs, const std::function<void()>& work)
{
  std::vector<Seconds> measured;
  double total = 0.0;
  for (int run = 0; run < runs && total < LongSeconds; ++run)
  {
    measured.push_back(timed(work));
    total += measured.back().wall;
  }
  return median(measured);
}

evolving::Execution executionOn(int threads)
{
  if (threads <= 1)
  {
    return {};
  }
  const auto parallelFor = [threads](
                             std::int64_t count, const std::function<void(std::int64_t)>& task)
  {
    std::atomic<std::int64_t> next{ 0 };
    const auto work = [&]
    {
      for (std::int64_t i = next++; i < count; i = next++)
      {
        task(i);
      }
    };
    std::vector<std::thread> pool;
    for (int t = 1; t < threads && t < count; ++t)
    {
      pool.emplace_back(work);
    }
    work();
    for (std::thread& thread : pool)
    {
      thread.join();
    }
  };
  return evolving::Execution(parallelFor, nullptr, nullptr);
}

} // namespace benchmark
