// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/OrderedTasks.h"

#include "Errors.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace evolving;

/// Some places each, now and then none.
std::vector<std::vector<Index>> somePlaces(std::size_t tasks, Index placeCount)
{
  std::mt19937 random(5);
  std::vector<std::vector<Index>> places(tasks);
  for (std::vector<Index>& mine : places)
  {
    for (auto k = random() % 6; k > 0; --k)
    {
      mine.push_back(static_cast<Index>(random() % 1000U) % placeCount);
    }
  }
  return places;
}

/// A task whose outcome depends on the order: every value at its places becomes a mixture.
void mix(std::vector<std::uint64_t>& values, const std::vector<Index>& places, std::size_t task)
{
  std::uint64_t sum = task;
  for (const Index place : places)
  {
    sum = 31 * sum + values[static_cast<std::size_t>(place)];
  }
  for (const Index place : places)
  {
    values[static_cast<std::size_t>(place)] = sum;
  }
}

TEST(OrderedTasks, HaveTheOutcomeOfOneAfterTheOther)
{
  constexpr Index PlaceCount = 300;
  const auto places = somePlaces(2000, PlaceCount);
  std::vector<std::uint64_t> expected(PlaceCount, 1);
  for (std::size_t task = 0; task < places.size(); ++task)
  {
    mix(expected, places[task], task);
  }
  for (const int threads : { 1, 2, 4 })
  {
    for (const std::int64_t grain : { 1, 7, 5000 })
    {
      std::vector<std::uint64_t> values(PlaceCount, 1);
      runInOrder(
        places.size(), [&](std::size_t task) { return places[task]; }, PlaceCount, grain,
        [&](std::size_t task) { mix(values, places[task], task); }, threadedExecution(threads, 3));
      EXPECT_EQ(values, expected);
    }
  }
}

TEST(OrderedTasks, RunOnceEach)
{
  const auto places = somePlaces(500, 10);
  std::vector<int> runs(places.size(), 0);
  runInOrder(
    places.size(), [&](std::size_t task) { return places[task]; }, 10, 3,
    [&](std::size_t task) { ++runs[task]; });
  EXPECT_EQ(runs, std::vector<int>(places.size(), 1));
}

TEST(OrderedTasks, ThatAreFarApartDoNotWaitForEachOther)
{
  std::vector<std::int64_t> chunksOfLoops;
  const Execution counting(
    [&](std::int64_t count, const std::function<void(std::int64_t)>& task)
    {
      chunksOfLoops.push_back(count);
      for (std::int64_t chunk = 0; chunk < count; ++chunk)
      {
        task(chunk);
      }
    },
    [](double) {}, [] { return false; });
  runInOrder(
    40, [](std::size_t task) { return std::vector<Index>{ static_cast<Index>(task) }; }, 40, 10,
    [](std::size_t) {}, counting);
  EXPECT_EQ(chunksOfLoops, std::vector<std::int64_t>{ 4 });
}

TEST(OrderedTasks, ThrowWhatTheFirstOfATurnThrew)
{
  // Tasks 0 to 9 have a place each, and the others wait for them: they must not run at all.
  const auto placesOf = [](std::size_t task)
  { return std::vector<Index>{ static_cast<Index>(task % 10) }; };
  for (const int threads : { 1, 2, 8 })
  {
    std::vector<int> runs(40, 0);
    try
    {
      runInOrder(
        runs.size(), placesOf, 10, 1,
        [&](std::size_t task)
        {
          ++runs[task];
          if (task == 3 || task == 7 || task == 12)
          {
            throw InputError(std::to_string(task));
          }
        },
        threadedExecution(threads, 3));
      FAIL() << "nothing was thrown";
    }
    catch (const InputError& error)
    {
      EXPECT_STREQ(error.what(), "3");
    }
    EXPECT_EQ(std::vector<int>(runs.begin() + 10, runs.end()), std::vector<int>(30, 0));
  }
}

TEST(OrderedTasks, MayBeNone)
{
  runInOrder(
    0, [](std::size_t) { return std::vector<Index>{}; }, 0, 1, [](std::size_t) { FAIL(); });
}

} // namespace
