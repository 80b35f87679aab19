// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/OrderedTasks.h"

#include "ParallelLoops.h"

#include <algorithm>

namespace evolving
{

namespace
{

/// Tasks whose places nobody else has, after those that had them before.
std::vector<std::vector<std::size_t>> turnsOf(
  std::size_t count, const PlacesOfTask& placesOf, Index placeCount)
{
  std::vector<std::vector<std::size_t>> turns;
  std::vector<std::size_t> nextTurn(at(placeCount), 0);
  for (std::size_t task = 0; task < count; ++task)
  {
    const std::vector<Index> places = placesOf(task);
    std::size_t turn = 0;
    for (const Index place : places)
    {
      turn = std::max(turn, nextTurn[at(place)]);
    }
    for (const Index place : places)
    {
      nextTurn[at(place)] = turn + 1;
    }
    turns.resize(std::max(turns.size(), turn + 1));
    turns[turn].push_back(task);
  }
  return turns;
}

} // namespace

void runInOrder(std::size_t count, const PlacesOfTask& placesOf, Index placeCount,
  std::int64_t grain, const std::function<void(std::size_t task)>& run, const Execution& execution)
{
  for (const std::vector<std::size_t>& turn : turnsOf(count, placesOf, placeCount))
  {
    execution.forRange(static_cast<std::int64_t>(turn.size()), grain,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t i = begin; i < end; ++i)
        {
          run(turn[static_cast<std::size_t>(i)]);
        }
      });
  }
}

} // namespace evolving
