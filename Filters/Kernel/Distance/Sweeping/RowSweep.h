// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The order in which a sweep visits the rows of a grid, and the rows it may visit together.
 */

#ifndef EVOLVING_ROW_SWEEP_H
#define EVOLVING_ROW_SWEEP_H

#include "Execution.h"

#include <functional>

namespace evolving
{

/// Which way a sweep runs along the slower axes.
struct SweepDirection
{
  bool yUp = true;
  bool zUp = true;
};

/// A row of samples along x: numbers along y and z from the first of the grid, in memory order.
using RowVisit = std::function<void(int j, int k)>;

/**
 * Visits all rows so that a row comes after those before it along y and z (in the sweep's
 * direction) and before those behind it. Rows are visited in square tiles; the tiles of one
 * diagonal have no neighbours among each other and run in parallel, so that a body that writes
 * its own row and reads the eight around it has the result of the serial order.
 * @throws Cancelled between diagonals
 */
void visitRowsInOrder(int rows, int slices, const SweepDirection& direction,
  const Execution& execution, const RowVisit& visit);

} // namespace evolving

#endif
