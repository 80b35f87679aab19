// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Sweeping/RowSweep.h"

#include <algorithm>

namespace evolving
{

namespace
{

/// Rows along each side of a tile: enough tiles for the threads, few enough loops.
constexpr int TileSide = 8;

int tileCount(int rows)
{
  return (rows + TileSide - 1) / TileSide;
}

/// The rows of one tile, (a, b) counted in the sweep's direction.
void visitTile(int tileA, int tileB, int rows, int slices, const SweepDirection& direction,
  const RowVisit& visit)
{
  const int endA = std::min(rows, (tileA + 1) * TileSide);
  const int endB = std::min(slices, (tileB + 1) * TileSide);
  for (int b = tileB * TileSide; b < endB; ++b)
  {
    for (int a = tileA * TileSide; a < endA; ++a)
    {
      visit(direction.yUp ? a : rows - 1 - a, direction.zUp ? b : slices - 1 - b);
    }
  }
}

} // namespace

void visitRowsInOrder(int rows, int slices, const SweepDirection& direction,
  const Execution& execution, const RowVisit& visit)
{
  const int tilesA = tileCount(rows);
  const int tilesB = tileCount(slices);
  const int diagonals = tilesA + tilesB - 1;
  for (int diagonal = 0; diagonal < diagonals; ++diagonal)
  {
    execution.report(static_cast<double>(diagonal) / diagonals);
    const int first = std::max(0, diagonal - tilesA + 1);
    const int last = std::min(tilesB - 1, diagonal);
    execution.forRange(last - first + 1, 1,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (auto n = static_cast<int>(begin); n < static_cast<int>(end); ++n)
        {
          const int tileB = first + n;
          visitTile(diagonal - tileB, tileB, rows, slices, direction, visit);
        }
      });
  }
}

} // namespace evolving
