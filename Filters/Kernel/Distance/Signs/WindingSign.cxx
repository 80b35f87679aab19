// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/WindingSign.h"

#include "Distance/Signs/WindingWalk.h"

#include <algorithm>

namespace evolving
{

namespace
{

/// Rows of samples, the first sample of each reached from the one before.
class RowsInside
{
public:
  RowsInside(const WindingField& field, const DistanceGrid& grid,
    const std::vector<float>& clearance, std::vector<char>& inside)
    : Field(field)
    , Grid(grid)
    , Clearance(clearance)
    , Inside(inside)
  {
  }

  /// Rows [begin, end), numbered along y, z.
  void fill(std::int64_t begin, std::int64_t end) const
  {
    const int height = this->Grid.dimension(1);
    while (begin < end)
    {
      const auto k = static_cast<int>(begin / height);
      const auto j = static_cast<int>(begin % height);
      const int count = static_cast<int>(std::min<std::int64_t>(end - begin, height - j));
      this->fillSlice(k, j, count);
      begin += count;
    }
  }

private:
  Vec3 point(int i, int j, int k) const
  {
    const Extent& e = this->Grid.extent;
    return this->Grid.point(e[0] + i, e[2] + j, e[4] + k);
  }
  void step(WindingWalk& walk, const Vec3& to, std::size_t sample, double length,
    const CrossingChange& change) const
  {
    const auto clearance = static_cast<double>(this->Clearance[sample]);
    this->Inside[sample] = walk.isInside({ to, clearance, length, change });
  }

  /// Rows of one z.
  void fillSlice(int k, int firstRow, int count) const
  {
    const Vec3& spacing = this->Grid.spacing;
    const auto width = static_cast<std::size_t>(this->Grid.dimension(0));
    const Vec3 first = this->point(0, firstRow, k);
    Crossings betweenRows = this->Field.crossings(first, spacing.y() * Vec3::UnitY());
    WindingWalk upwards(this->Field);
    for (int row = 0; row < count; ++row)
    {
      const int j = firstRow + row;
      const std::size_t sample = (at(k) * at(this->Grid.dimension(1)) + at(j)) * width;
      const Vec3 start = this->point(0, j, k);
      this->step(upwards, start, sample, spacing.y(), betweenRows.changeUpTo(row));
      Crossings crossings = this->Field.crossings(start, spacing.x() * Vec3::UnitX());
      crossings.changeUpTo(0);
      WindingWalk along = upwards;
      for (int i = 1; i < this->Grid.dimension(0); ++i)
      {
        this->step(
          along, this->point(i, j, k), sample + at(i), spacing.x(), crossings.changeUpTo(i));
      }
    }
  }

  const WindingField& Field;
  const DistanceGrid& Grid;
  const std::vector<float>& Clearance;
  std::vector<char>& Inside;
};

} // namespace

std::vector<char> insideByWindingNumber(const DistanceTarget& target, const DistanceGrid& grid,
  const std::vector<float>& clearance, const Execution& execution)
{
  const WindingField field(target, grid, execution.phase(0.0, 0.3));
  std::vector<char> inside(clearance.size(), 0);
  const RowsInside rows(field, grid, clearance, inside);
  constexpr std::int64_t RowGrain = 16;
  execution.phase(0.3, 1.0).forRangeReporting(std::int64_t(grid.dimension(1)) * grid.dimension(2),
    RowGrain, [&](std::int64_t begin, std::int64_t end) { rows.fill(begin, end); });
  return inside;
}

} // namespace evolving
