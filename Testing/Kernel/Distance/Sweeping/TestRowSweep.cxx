// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Sweeping/RowSweep.h"

#include "Errors.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

using namespace evolving;

TEST(RowSweep, VisitsEveryRowOnceAfterThoseBeforeIt)
{
  for (const SweepDirection direction :
    { SweepDirection{ true, true }, { false, true }, { true, false }, { false, false } })
  {
    for (const int threads : { 1, 4 })
    {
      const int rows = 29;
      const int slices = 18;
      std::vector<std::atomic<int>> stamp(static_cast<std::size_t>(rows * slices));
      std::atomic<int> clock{ 0 };
      std::atomic<int> violations{ 0 };
      const auto at = [&](int j, int k) -> std::atomic<int>&
      { return stamp[static_cast<std::size_t>(k * rows + j)]; };
      visitRowsInOrder(rows, slices, direction, threadedExecution(threads, 3),
        [&](int j, int k)
        {
          const int beforeJ = direction.yUp ? j - 1 : j + 1;
          const int beforeK = direction.zUp ? k - 1 : k + 1;
          const bool hasJ = beforeJ >= 0 && beforeJ < rows;
          const bool hasK = beforeK >= 0 && beforeK < slices;
          violations += hasJ && at(beforeJ, k) == 0 ? 1 : 0;
          violations += hasK && at(j, beforeK) == 0 ? 1 : 0;
          violations += hasJ && hasK && at(beforeJ, beforeK) == 0 ? 1 : 0;
          violations += at(j, k) != 0 ? 1 : 0;
          at(j, k) = ++clock;
        });
      EXPECT_EQ(clock, rows * slices);
      EXPECT_EQ(violations, 0);
    }
  }
}

TEST(RowSweep, StopsWhenAsked)
{
  int visited = 0;
  const Execution stopping(nullptr, nullptr, [&] { return visited > 300; });
  EXPECT_THROW(visitRowsInOrder(100, 100, {}, stopping, [&](int, int) { ++visited; }), Cancelled);
  EXPECT_LT(visited, 1000);
}
