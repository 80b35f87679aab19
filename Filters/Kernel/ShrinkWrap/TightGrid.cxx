// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/TightGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evolving
{

namespace
{

/// One for the cells that the outermost surface passes, one for the differences at their corners,
/// one for the samples around that OuterRegion looks at.
constexpr double CellsOfRoom = 3.0;

/// Along an axis, between the cells of room.
double cellsAcross(const std::array<int, 3>& dimensions, int axis)
{
  const double cells = dimensions[static_cast<std::size_t>(axis)] - 1 - 2.0 * CellsOfRoom;
  return std::max(1.0, cells);
}

} // namespace

DistanceGrid tightGrid(const Box& box, const std::array<int, 3>& dimensions, double room)
{
  double cell = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    cell = std::max(cell, (box.sizes()[axis] + 2.0 * room) / cellsAcross(dimensions, axis));
  }
  DistanceGrid grid;
  grid.spacing.setConstant(cell);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double side = box.sizes()[axis] + 2.0 * room + 2.0 * CellsOfRoom * cell;
    const int cells = static_cast<int>(std::ceil(side / cell - 1e-9));
    grid.origin[axis] = box.center()[axis] - 0.5 * cells * cell;
    const auto lower = static_cast<std::size_t>(2 * axis);
    grid.extent[lower] = 0;
    grid.extent[lower + 1] = cells;
  }
  return grid;
}

int samplesForCells(const Box& box, double room, double cell)
{
  const double longest = box.sizes().maxCoeff() + 2.0 * room;
  return static_cast<int>(std::ceil(longest / cell + 1.0 + 2.0 * CellsOfRoom));
}

double roomForCells(const Box& box, const std::array<int, 3>& dimensions, double cell)
{
  double room = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    room = std::min(room, 0.5 * (cell * cellsAcross(dimensions, axis) - box.sizes()[axis]));
  }
  return room;
}

} // namespace evolving
