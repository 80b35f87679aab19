// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Errors.h"
#include "Execution.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace evolving
{

namespace
{

using Chunk = std::pair<std::int64_t, std::int64_t>;

constexpr std::int64_t Grain = 10;

template <typename Loop>
std::vector<Chunk> sortedChunks(const Loop& loop)
{
  std::vector<Chunk> chunks;
  std::mutex mutex;
  loop(
    [&](std::int64_t begin, std::int64_t end)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      chunks.emplace_back(begin, end);
    });
  std::sort(chunks.begin(), chunks.end());
  return chunks;
}

std::vector<Chunk> expectedChunks(std::int64_t count)
{
  std::vector<Chunk> chunks;
  for (std::int64_t begin = 0; begin < count; begin += Grain)
  {
    chunks.emplace_back(begin, std::min(count, begin + Grain));
  }
  return chunks;
}

double harmonicSum(std::int64_t begin, std::int64_t end)
{
  double sum = 0.0;
  for (std::int64_t i = begin; i < end; ++i)
  {
    sum += 1.0 / static_cast<double>(i + 1);
  }
  return sum;
}

TEST(Execution, CutsLoopsAtMultiplesOfTheGrain)
{
  for (const int threads : { 1, 2, 8 })
  {
    const Execution execution = threadedExecution(threads, 7);
    for (const std::int64_t count : { 0, 1, 9, 10, 11, 20, 95, 1000 })
    {
      const auto whole = sortedChunks(
        [&](const Execution::RangeBody& body) { execution.forRange(count, Grain, body); });
      const auto reporting = sortedChunks(
        [&](const Execution::RangeBody& body) { execution.forRangeReporting(count, Grain, body); });
      EXPECT_EQ(whole, expectedChunks(count)) << count << " items, " << threads << " threads";
      EXPECT_EQ(reporting, expectedChunks(count)) << count << " items, " << threads << " threads";
    }
  }
}

TEST(Execution, SumsHaveTheSameBitsForAnyThreadsAndOrder)
{
  constexpr std::int64_t Count = 123457;
  const double serial = Execution().sumRange(Count, 1024, harmonicSum);
  EXPECT_NEAR(serial, std::log(Count) + 0.5772156649015329 + 0.5 / Count, 1e-9);
  for (const int threads : { 1, 2, 3, 8 })
  {
    for (const unsigned seed : { 1U, 2U, 3U })
    {
      EXPECT_EQ(threadedExecution(threads, seed).sumRange(Count, 1024, harmonicSum), serial);
    }
  }
  EXPECT_NE(harmonicSum(0, Count), serial) << "the order of summation does not matter here";
}

/// Throws in the chunks that begin at one of the numbers.
Execution::RangeBody throwingAt(const std::vector<std::int64_t>& begins)
{
  return [begins](std::int64_t begin, std::int64_t)
  {
    if (std::find(begins.begin(), begins.end(), begin) != begins.end())
    {
      throw InputError(std::to_string(begin));
    }
  };
}

/// What the loop throws: the message of an InputError, otherwise nothing.
template <typename Loop>
std::string thrownBy(const Loop& loop)
{
  try
  {
    loop();
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

TEST(Execution, LoopsThrowWhatTheirFirstFailingChunkThrew)
{
  for (const int threads : { 1, 2, 8 })
  {
    for (const unsigned seed : { 1U, 2U, 3U })
    {
      const Execution execution = threadedExecution(threads, seed);
      for (const std::vector<std::int64_t>& failing : std::vector<std::vector<std::int64_t>>{
             { 0 }, { 990 }, { 500, 510, 640, 20, 980 }, { 30, 40, 50, 60, 70 } })
      {
        const auto body = throwingAt(failing);
        const std::string first = std::to_string(*std::min_element(failing.begin(), failing.end()));
        EXPECT_EQ(thrownBy([&] { execution.forRange(1000, Grain, body); }), first);
        EXPECT_EQ(thrownBy([&] { execution.forRangeReporting(1000, Grain, body); }), first);
        EXPECT_EQ(thrownBy(
                    [&]
                    {
                      execution.sumRange(1000, Grain,
                        [&](std::int64_t begin, std::int64_t end)
                        {
                          body(begin, end);
                          return 1.0;
                        });
                    }),
          first);
      }
    }
  }
}

TEST(Execution, LoopsWorkAgainAfterOneThatThrew)
{
  const Execution execution = threadedExecution(8, 1);
  EXPECT_THROW(execution.forRange(1000, Grain, throwingAt({ 0, 500 })), InputError);
  EXPECT_EQ(
    sortedChunks([&](const Execution::RangeBody& body) { execution.forRange(1000, Grain, body); }),
    expectedChunks(1000));
}

TEST(Execution, ChunksBehindAFailureAreSkipped)
{
  std::int64_t calls = 0;
  EXPECT_THROW(Execution().forRange(1000, Grain,
                 [&](std::int64_t begin, std::int64_t)
                 {
                   ++calls;
                   if (begin == 50)
                   {
                     throw std::bad_alloc();
                   }
                 }),
    std::bad_alloc);
  EXPECT_EQ(calls, 6);
}

TEST(Execution, SumOfNothingIsZero)
{
  EXPECT_EQ(Execution().sumRange(0, Grain, harmonicSum), 0.0);
}

TEST(Execution, ProgressIsMonotoneFromZeroToOne)
{
  std::vector<double> fractions;
  const Execution execution(
    nullptr, [&](double fraction) { fractions.push_back(fraction); }, nullptr);
  execution.forRangeReporting(1000, Grain, [](std::int64_t, std::int64_t) {});
  ASSERT_GE(fractions.size(), 2U);
  EXPECT_EQ(fractions.front(), 0.0);
  EXPECT_EQ(fractions.back(), 1.0);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
}

TEST(Execution, PhasesNestAndClamp)
{
  double reported = -1.0;
  const Execution whole(
    nullptr, [&](double fraction) { reported = fraction; }, nullptr);
  const Execution half = whole.phase(0.5, 1.0);
  const Execution eighth = half.phase(0.25, 0.5);
  eighth.report(0.0);
  EXPECT_DOUBLE_EQ(reported, 0.625);
  eighth.report(0.5);
  EXPECT_DOUBLE_EQ(reported, 0.6875);
  eighth.report(1.0);
  EXPECT_DOUBLE_EQ(reported, 0.75);
  eighth.report(17.0);
  EXPECT_DOUBLE_EQ(reported, 0.75);
  eighth.report(-3.0);
  EXPECT_DOUBLE_EQ(reported, 0.625);
}

TEST(Execution, StopsBetweenBatches)
{
  std::int64_t asked = 0;
  std::atomic<std::int64_t> chunks{ 0 };
  const Execution execution(nullptr, nullptr, [&] { return ++asked == 3; });
  EXPECT_THROW(
    execution.forRangeReporting(100000, 1, [&](std::int64_t, std::int64_t) { ++chunks; }),
    Cancelled);
  EXPECT_EQ(asked, 3);
  EXPECT_GT(chunks, 0);
  EXPECT_LT(chunks, 100000);
}

TEST(Execution, StopIsSeenInsideAPhaseAndReportsNothingMore)
{
  bool stop = false;
  int reports = 0;
  const Execution execution(
    nullptr, [&](double) { ++reports; }, [&] { return stop; });
  const Execution phase = execution.phase(0.0, 0.5);
  EXPECT_NO_THROW(phase.report(0.1));
  stop = true;
  EXPECT_THROW(phase.report(0.2), Cancelled);
  EXPECT_EQ(reports, 1);
}

} // namespace

} // namespace evolving
