// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Execution.h"

#include "Errors.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

namespace evolving
{

namespace
{

std::int64_t chunkCount(std::int64_t count, std::int64_t grain)
{
  return (count + grain - 1) / grain;
}

void runSerially(std::int64_t count, const std::function<void(std::int64_t)>& task)
{
  for (std::int64_t i = 0; i < count; ++i)
  {
    task(i);
  }
}

/// The exception of the first task, in the order of their numbers, that throws; tasks may run on
/// any thread and in any order, so that all before it must run, and those behind it need not.
class FirstFailure
{
public:
  template <class Task>
  void run(std::int64_t number, const Task& task)
  {
    if (number > this->First.load(std::memory_order_relaxed))
    {
      return;
    }
    try
    {
      task(number);
    }
    catch (...)
    {
      this->keep(number, std::current_exception());
    }
  }

  void rethrow() const
  {
    if (this->Failure)
    {
      std::rethrow_exception(this->Failure);
    }
  }

private:
  void keep(std::int64_t number, std::exception_ptr failure)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (number < this->First)
    {
      this->First = number;
      this->Failure = std::move(failure);
    }
  }

  std::atomic<std::int64_t> First{ std::numeric_limits<std::int64_t>::max() };
  std::exception_ptr Failure;
  std::mutex Mutex;
};

/// As parallelFor, but tasks may throw.
void runTasks(const Execution::ParallelFor& parallelFor, std::int64_t count,
  const std::function<void(std::int64_t)>& task)
{
  FirstFailure failure;
  parallelFor(count, [&](std::int64_t number) { failure.run(number, task); });
  failure.rethrow();
}

} // namespace

Execution::Execution()
  : Execution(nullptr, nullptr, nullptr)
{
}

Execution::Execution(ParallelFor parallelFor, Progress progress, StopRequest stopRequest)
  : Parallel(parallelFor ? std::move(parallelFor) : ParallelFor(runSerially))
  , Report(std::move(progress))
  , Stop(std::move(stopRequest))
{
}

void Execution::forRange(std::int64_t count, std::int64_t grain, const RangeBody& body) const
{
  const std::int64_t chunks = chunkCount(count, grain);
  if (chunks <= 1)
  {
    if (count > 0)
    {
      body(0, count);
    }
    return;
  }
  runTasks(this->Parallel, chunks,
    [count, grain, &body](std::int64_t chunk)
    { body(chunk * grain, std::min(count, (chunk + 1) * grain)); });
}

void Execution::forRangeReporting(
  std::int64_t count, std::int64_t grain, const RangeBody& body) const
{
  using Clock = std::chrono::steady_clock;
  constexpr double BatchSeconds = 0.1; // a tenth of what a user notices
  const std::int64_t chunks = chunkCount(count, grain);
  std::int64_t batch = 4;
  for (std::int64_t done = 0; done < chunks;)
  {
    this->report(static_cast<double>(done) / static_cast<double>(chunks));
    const std::int64_t end = std::min(chunks, done + batch);
    const auto start = Clock::now();
    runTasks(this->Parallel, end - done,
      [=, &body](std::int64_t task)
      {
        const std::int64_t chunk = done + task;
        body(chunk * grain, std::min(count, (chunk + 1) * grain));
      });
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    batch = seconds < BatchSeconds / 2 ? batch * 2 : batch;
    batch = seconds > BatchSeconds * 2 ? std::max<std::int64_t>(batch / 2, 1) : batch;
    done = end;
  }
  this->report(1.0);
}

double Execution::sumRange(std::int64_t count, std::int64_t grain, const RangeSum& sum) const
{
  std::vector<double> partial(static_cast<std::size_t>(chunkCount(count, grain)), 0.0);
  this->forRange(count, grain,
    [&](std::int64_t begin, std::int64_t end)
    { partial[static_cast<std::size_t>(begin / grain)] = sum(begin, end); });
  double total = 0.0;
  for (const double value : partial)
  {
    total += value;
  }
  return total;
}

void Execution::report(double fraction) const
{
  if (this->Stop && this->Stop())
  {
    throw Cancelled();
  }
  if (this->Report)
  {
    this->Report(this->From + (this->To - this->From) * std::clamp(fraction, 0.0, 1.0));
  }
}

Execution Execution::phase(double from, double to) const
{
  Execution part = *this;
  part.From = this->From + (this->To - this->From) * from;
  part.To = this->From + (this->To - this->From) * to;
  return part;
}

} // namespace evolving
