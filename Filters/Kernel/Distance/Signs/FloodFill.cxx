// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/FloodFill.h"

#include <algorithm>
#include <array>
#include <utility>

namespace evolving
{

namespace
{

enum Side : char
{
  Outside = 0,
  Inside = 1,
  Unknown = 2,
};

class Flood
{
public:
  Flood(const DistanceGrid& grid, const std::vector<float>& clearance, const Execution& execution)
    : Dimensions{ grid.dimension(0), grid.dimension(1), grid.dimension(2) }
    , Spacing(grid.spacing)
    , Clearance(clearance)
    , Run(execution)
    , SideOf(clearance.size(), Unknown)
  {
  }

  bool isKnown(GridIndex sample) const { return this->side(sample) != Unknown; }
  void set(GridIndex sample, Side side) { this->SideOf[static_cast<std::size_t>(sample)] = side; }

  /// Gives a side to a sample and to all that can be reached from it.
  void fillFrom(GridIndex seed, Side side)
  {
    this->set(seed, side);
    this->Pending.push_back(seed);
    while (!this->Pending.empty())
    {
      const GridIndex sample = this->Pending.back();
      this->Pending.pop_back();
      this->reportProgress();
      this->fillNeighbours(sample, side);
    }
  }

  /// Are there samples of this side, and none of the other, among the 26 around a sample?
  bool isSurroundedBy(Side side, GridIndex sample) const
  {
    const std::array<GridIndex, 3> place = this->place(sample);
    std::array<GridIndex, 3> first;
    std::array<GridIndex, 3> last;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      first[axis] = std::max<GridIndex>(place[axis] - 1, 0);
      last[axis] = std::min(place[axis] + 1, this->Dimensions[axis] - 1);
    }
    std::array<int, 3> count{ 0, 0, 0 };
    for (GridIndex k = first[2]; k <= last[2]; ++k)
    {
      for (GridIndex j = first[1]; j <= last[1]; ++j)
      {
        for (GridIndex i = first[0]; i <= last[0]; ++i)
        {
          const GridIndex other = (k * this->Dimensions[1] + j) * this->Dimensions[0] + i;
          ++count[static_cast<std::size_t>(this->side(other))];
        }
      }
    }
    return count[static_cast<std::size_t>(side)] > 0 &&
      count[static_cast<std::size_t>(1 - side)] == 0;
  }

  bool isOnBoundary(GridIndex sample) const
  {
    const std::array<GridIndex, 3> place = this->place(sample);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (place[axis] == 0 || place[axis] == this->Dimensions[axis] - 1)
      {
        return true;
      }
    }
    return false;
  }

  /// The sides; samples still unknown are inside when they are in the list.
  std::vector<char> takeSides(const std::vector<GridIndex>& inside)
  {
    for (const GridIndex sample : inside)
    {
      this->set(sample, Inside);
    }
    std::replace(this->SideOf.begin(), this->SideOf.end(), char(Unknown), char(Outside));
    return std::move(this->SideOf);
  }

private:
  std::array<GridIndex, 3> place(GridIndex sample) const
  {
    const GridIndex row = sample / this->Dimensions[0];
    return { sample % this->Dimensions[0], row % this->Dimensions[1], row / this->Dimensions[1] };
  }
  char side(GridIndex sample) const { return this->SideOf[static_cast<std::size_t>(sample)]; }
  double clearance(GridIndex sample) const
  {
    return static_cast<double>(this->Clearance[static_cast<std::size_t>(sample)]);
  }

  void fillNeighbours(GridIndex sample, Side side)
  {
    const std::array<GridIndex, 3> place = this->place(sample);
    GridIndex stride = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (place[axis] > 0)
      {
        this->fillIfOnSameSide(sample, sample - stride, axis, side);
      }
      if (place[axis] + 1 < this->Dimensions[axis])
      {
        this->fillIfOnSameSide(sample, sample + stride, axis, side);
      }
      stride *= this->Dimensions[axis];
    }
  }

  void fillIfOnSameSide(GridIndex from, GridIndex to, std::size_t axis, Side side)
  {
    constexpr double Rounding = 1.0 + 1e-6;
    const double spacing = this->Spacing[static_cast<int>(axis)];
    if (!this->isKnown(to) && this->clearance(from) + this->clearance(to) > Rounding * spacing)
    {
      this->set(to, side);
      this->Pending.push_back(to);
    }
  }

  void reportProgress()
  {
    constexpr GridIndex Interval = 1 << 20;
    if (++this->Visited % Interval == 0)
    {
      this->Run.report(
        static_cast<double>(this->Visited) / static_cast<double>(this->SideOf.size()));
    }
  }

  std::array<GridIndex, 3> Dimensions;
  Vec3 Spacing;
  const std::vector<float>& Clearance;
  const Execution& Run;
  std::vector<char> SideOf;
  std::vector<GridIndex> Pending;
  GridIndex Visited = 0;
};

} // namespace

std::vector<char> floodFill(const DistanceGrid& grid, const std::vector<float>& clearance,
  const FloodFillQueries& queries, const Execution& execution)
{
  Flood flood(grid, clearance, execution);
  const GridIndex count = grid.sampleCount();
  for (GridIndex sample = 0; sample < count; ++sample)
  {
    if (flood.isOnBoundary(sample) && !flood.isKnown(sample))
    {
      flood.fillFrom(sample, queries.isInside && queries.isInside(sample) ? Inside : Outside);
    }
  }
  for (GridIndex sample = 0; sample < count; ++sample)
  {
    if (!flood.isKnown(sample) && !queries.isNearSurface(sample))
    {
      flood.fillFrom(sample, Inside);
    }
  }
  std::vector<GridIndex> insideToo;
  for (GridIndex sample = 0; sample < count; ++sample)
  {
    if (!flood.isKnown(sample) &&
      (flood.isSurroundedBy(Inside, sample) || queries.isBehindSurface(sample)))
    {
      insideToo.push_back(sample);
    }
  }
  return flood.takeSides(insideToo);
}

} // namespace evolving
