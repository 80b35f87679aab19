// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Work in a process of its own, which may crash, hang or eat memory without harm to us.
 */

#ifndef ROBUSTNESS_CHILD_PROCESS_H
#define ROBUSTNESS_CHILD_PROCESS_H

#include "ChildMessages.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace robustness
{

/// Under a sanitizer all takes several times as long, and maps far more memory than it uses.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool IsSanitized = true;
#else
constexpr bool IsSanitized = false;
#endif

struct ChildLimits
{
  int cpuSeconds = 60;
  int wallSeconds = 300; ///< for those that wait for ever: a busy machine makes no time-outs
  std::size_t bytes = std::size_t(2) << 30; ///< not under sanitizers
};

/**
 * Children that run side by side. The parent must not have threads: it forks without exec, so that
 * a child costs next to nothing.
 */
class ChildPool
{
public:
  using Work = std::function<void(std::uint64_t seed, const Messenger&)>;

  ChildPool(const ChildLimits& limits, Work work);
  /// Ends those that still run.
  ~ChildPool();
  ChildPool(const ChildPool&) = delete;
  ChildPool& operator=(const ChildPool&) = delete;

  void start(std::uint64_t seed);
  std::size_t size() const { return this->Running.size(); }
  /// The next one that ends; waits for it.
  ChildResult wait();

private:
  struct Child
  {
    std::uint64_t seed;
    int process;
    int pipe;   ///< what it tells
    int errors; ///< a file with what it printed
    std::chrono::steady_clock::time_point start;
    bool isOverdue = false;
    std::string told;
  };

  void listen(int milliseconds);
  void endOverdue();
  static ChildResult resultOf(const Child& child, int status);

  ChildLimits Limits;
  Work Task;
  std::vector<Child> Running;
};

} // namespace robustness

#endif
