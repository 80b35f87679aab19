// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Sweeping/FastSweeping.h"

#include "Distance/Sweeping/RowSweep.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// Above any distance; small enough that sums of three stay finite.
constexpr float Unreached = 1e30F;

struct Directions
{
  bool xUp;
  SweepDirection rows;
};

constexpr std::array<Directions, 8> SweepOrder{ {
  { true, { true, true } },
  { false, { true, true } },
  { false, { false, true } },
  { false, { false, false } },
  { false, { true, false } },
  { true, { true, false } },
  { true, { false, false } },
  { true, { false, true } },
} };

/// What a sample can still become: the smaller of its neighbours along one axis.
void smallerNeighbours(
  const SweptField& field, int j, int k, std::vector<float>& alongY, std::vector<float>& alongZ)
{
  const auto row = [&field](int rowJ, int rowK) -> const float*
  {
    const bool exists =
      rowJ >= 0 && rowJ < field.dimensions[1] && rowK >= 0 && rowK < field.dimensions[2];
    return exists ? field.distance.data() + field.index(0, rowJ, rowK) : nullptr;
  };
  const auto smaller = [width = field.dimensions[0]](
                         const float* a, const float* b, std::vector<float>& result)
  {
    a = a ? a : b;
    b = b ? b : a;
    for (int i = 0; i < width; ++i)
    {
      result[static_cast<std::size_t>(i)] = a ? std::min(a[i], b[i]) : Unreached;
    }
  };
  smaller(row(j - 1, k), row(j + 1, k), alongY);
  smaller(row(j, k - 1), row(j, k + 1), alongZ);
}

/// Does the upwind equation have a solution below a distance? The test of a sample that has its
/// value already, without roots; changes below 1e-5 of a cell, the rounding of large distances,
/// are left.
bool canImprove(float distance, float x, float y, float z)
{
  constexpr float OneAndRounding = 1.00002F;
  const float overX = std::max(distance - x, 0.0F);
  const float overY = std::max(distance - y, 0.0F);
  const float overZ = std::max(distance - z, 0.0F);
  return overX * overX + overY * overY + overZ * overZ > OneAndRounding;
}

/// The solution for neighbours in any order.
float upwindSolution(float x, float y, float z)
{
  const float smallXY = std::min(x, y);
  const float largeXY = std::max(x, y);
  return godunovSolution(
    std::min(smallXY, z), std::max(smallXY, std::min(largeXY, z)), std::max(largeXY, z));
}

void sweepRow(SweptField& field, int j, int k, bool xUp)
{
  const int width = field.dimensions[0];
  thread_local std::vector<float> alongY;
  thread_local std::vector<float> alongZ;
  alongY.resize(static_cast<std::size_t>(width));
  alongZ.resize(static_cast<std::size_t>(width));
  smallerNeighbours(field, j, k, alongY, alongZ);

  float* distance = field.distance.data() + field.index(0, j, k);
  const char* frozen = field.frozen.data() + field.index(0, j, k);
  const int step = xUp ? 1 : -1;
  float behind = Unreached; // the sample just left
  for (int i = xUp ? 0 : width - 1; i >= 0 && i < width; i += step)
  {
    const int next = i + step;
    const float ahead = next >= 0 && next < width ? distance[next] : Unreached;
    const float x = std::min(behind, ahead);
    const float y = alongY[static_cast<std::size_t>(i)];
    const float z = alongZ[static_cast<std::size_t>(i)];
    if (canImprove(distance[i], x, y, z) && !frozen[i])
    {
      distance[i] = std::min(distance[i], upwindSolution(x, y, z));
    }
    behind = distance[i];
  }
}

} // namespace

SweptField::SweptField(const std::array<int, 3>& gridDimensions)
  : dimensions(gridDimensions)
{
  const GridIndex count = GridIndex(dimensions[0]) * dimensions[1] * dimensions[2];
  this->distance.assign(static_cast<std::size_t>(count), Unreached);
  this->frozen.assign(static_cast<std::size_t>(count), 0);
}

GridIndex SweptField::index(int i, int j, int k) const
{
  return (GridIndex(k) * this->dimensions[1] + j) * this->dimensions[0] + i;
}

void SweptField::freeze(GridIndex sample, float value)
{
  this->distance[static_cast<std::size_t>(sample)] = value;
  this->frozen[static_cast<std::size_t>(sample)] = 1;
}

float godunovSolution(float a1, float a2, float a3)
{
  // Relative to the smallest neighbour: far from the surface the squares would cancel.
  const float b2 = a2 - a1;
  const float b3 = a3 - a1;
  if (b2 >= 1.0F)
  {
    return a1 + 1.0F;
  }
  const float two = 0.5F * (b2 + std::sqrt(2.0F - b2 * b2));
  if (two <= b3)
  {
    return a1 + two;
  }
  const float sum = b2 + b3;
  const float discriminant = sum * sum - 3.0F * (b2 * b2 + b3 * b3 - 1.0F);
  return a1 + (sum + std::sqrt(std::max(discriminant, 0.0F))) / 3.0F;
}

void sweep(SweptField& field, int numberOfSweeps, const Execution& execution)
{
  for (int n = 0; n < numberOfSweeps; ++n)
  {
    const Directions& directions = SweepOrder[static_cast<std::size_t>(n % 8)];
    const double from = static_cast<double>(n) / numberOfSweeps;
    const double to = static_cast<double>(n + 1) / numberOfSweeps;
    visitRowsInOrder(field.dimensions[1], field.dimensions[2], directions.rows,
      execution.phase(from, to), [&](int j, int k) { sweepRow(field, j, k, directions.xUp); });
  }
}

} // namespace evolving
