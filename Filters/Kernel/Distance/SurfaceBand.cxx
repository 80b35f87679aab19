// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/SurfaceBand.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace evolving
{

namespace
{

/// Slices drawn by one task. Each task draws all triangles of its slab in their order, so that
/// no two write the same sample.
constexpr int SlabThickness = 4;

/// First and last, inclusive; empty when the first is larger.
struct SampleRange
{
  int first = 0;
  int last = -1;
  bool isEmpty() const { return this->first > this->last; }
};

SampleRange samplesBetween(const UnitGrid& grid, int axis, double low, double high)
{
  const double size = grid.dimensions[static_cast<std::size_t>(axis)];
  const double from = std::ceil((low - grid.origin[axis]) / grid.spacing[axis]);
  const double to = std::floor((high - grid.origin[axis]) / grid.spacing[axis]);
  return { static_cast<int>(std::clamp(from, 0.0, size)),
    static_cast<int>(std::clamp(to, -1.0, size - 1.0)) };
}

/// The part of a row that is at most `reach` away from the triangle's plane.
template <typename Scalar>
SampleRange nearPlane(const MeasuredTriangle<Scalar>& triangle, const UnitGrid& grid, double reach,
  int j, int k, const SampleRange& row)
{
  const Vec3 normal = triangle.unitNormal().template cast<double>();
  const Vec3 corner = triangle.corner().template cast<double>();
  const double height = normal.dot(grid.point(0, j, k) - corner);
  const double rise = normal.x() * grid.spacing.x();
  constexpr double Rounding = 1e-3; // of a cell; drawing a little more does no harm
  const double thickness = reach + Rounding;
  constexpr double Parallel = 1e-6;
  if (std::abs(rise) < Parallel)
  {
    const double change = Parallel * grid.dimensions[0];
    return std::abs(height) <= thickness + change ? row : SampleRange{};
  }
  const double a = (-thickness - height) / rise;
  const double b = (thickness - height) / rise;
  const double from = std::ceil(std::min(a, b));
  const double to = std::floor(std::max(a, b));
  return { static_cast<int>(std::max<double>(from, row.first)),
    static_cast<int>(std::min<double>(to, row.last)) };
}

/// Which triangles reach into which slab of slices.
class SlabLists
{
public:
  SlabLists(const std::vector<Box>& boxes, const UnitGrid& grid, double reach)
    : Offsets(static_cast<std::size_t>(slabCount(grid)) + 1, 0)
  {
    std::vector<SampleRange> slabs(boxes.size());
    for (std::size_t t = 0; t < boxes.size(); ++t)
    {
      SampleRange range =
        samplesBetween(grid, 2, boxes[t].min().z() - reach, boxes[t].max().z() + reach);
      slabs[t] = range.isEmpty()
        ? range
        : SampleRange{ range.first / SlabThickness, range.last / SlabThickness };
      for (int slab = slabs[t].first; slab <= slabs[t].last; ++slab)
      {
        ++this->Offsets[static_cast<std::size_t>(slab) + 1];
      }
    }
    std::partial_sum(this->Offsets.begin(), this->Offsets.end(), this->Offsets.begin());
    std::vector<std::size_t> place(this->Offsets.begin(), this->Offsets.end() - 1);
    this->Triangles.resize(this->Offsets.back());
    for (std::size_t t = 0; t < boxes.size(); ++t)
    {
      for (int slab = slabs[t].first; slab <= slabs[t].last; ++slab)
      {
        this->Triangles[place[static_cast<std::size_t>(slab)]++] = static_cast<Index>(t);
      }
    }
  }

  static int slabCount(const UnitGrid& grid)
  {
    return (grid.dimensions[2] + SlabThickness - 1) / SlabThickness;
  }
  const Index* begin(int slab) const { return this->at(static_cast<std::size_t>(slab)); }
  const Index* end(int slab) const { return this->at(static_cast<std::size_t>(slab) + 1); }

private:
  const Index* at(std::size_t slab) const { return this->Triangles.data() + this->Offsets[slab]; }

  std::vector<std::size_t> Offsets;
  std::vector<Index> Triangles;
};

/// Draws one triangle into the slices [first, last].
template <typename Scalar>
void draw(Index number, const MeasuredTriangle<Scalar>& triangle, const Box& box,
  const UnitGrid& grid, double reach, const SampleRange& slices, std::vector<Nearest>& nearest)
{
  const auto between = [&](int axis)
  { return samplesBetween(grid, axis, box.min()[axis] - reach, box.max()[axis] + reach); };
  const SampleRange columns = between(0);
  const SampleRange rows = between(1);
  const SampleRange depth = between(2);
  for (int k = std::max(depth.first, slices.first); k <= std::min(depth.last, slices.last); ++k)
  {
    for (int j = rows.first; j <= rows.last; ++j)
    {
      const SampleRange row = nearPlane(triangle, grid, reach, j, k, columns);
      for (int i = row.first; i <= row.last; ++i)
      {
        const auto point = grid.point(i, j, k).template cast<Scalar>().eval();
        const auto distance = static_cast<float>(std::sqrt(triangle.squaredDistance(point)));
        Nearest& sample = nearest[static_cast<std::size_t>(grid.index(i, j, k))];
        if (distance < sample.distance)
        {
          sample = { distance, number };
        }
      }
    }
  }
}

} // namespace

template <typename Scalar>
void drawSurfaceBand(const std::vector<MeasuredTriangle<Scalar>>& triangles,
  const std::vector<Box>& triangleBoxes, const UnitGrid& grid, double reach,
  std::vector<Nearest>& nearest, const Execution& execution)
{
  const SlabLists lists(triangleBoxes, grid, reach);
  execution.forRangeReporting(SlabLists::slabCount(grid), 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto slab = static_cast<int>(begin); slab < static_cast<int>(end); ++slab)
      {
        const int first = slab * SlabThickness;
        const SampleRange slices{ first, std::min(grid.dimensions[2], first + SlabThickness) - 1 };
        for (const Index* t = lists.begin(slab); t != lists.end(slab); ++t)
        {
          const auto number = static_cast<std::size_t>(*t);
          draw(*t, triangles[number], triangleBoxes[number], grid, reach, slices, nearest);
        }
      }
    });
}

template void drawSurfaceBand(const std::vector<MeasuredTriangle<float>>&, const std::vector<Box>&,
  const UnitGrid&, double, std::vector<Nearest>&, const Execution&);
template void drawSurfaceBand(const std::vector<MeasuredTriangle<double>>&, const std::vector<Box>&,
  const UnitGrid&, double, std::vector<Nearest>&, const Execution&);

} // namespace evolving
