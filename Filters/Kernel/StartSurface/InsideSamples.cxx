// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/InsideSamples.h"

#include "Errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace evolving
{

namespace
{

void requireMatchingLength(const DistanceGrid& grid, const std::vector<float>& field)
{
  const GridIndex expected = grid.sampleCount();
  if (expected < 1 || static_cast<GridIndex>(field.size()) != expected)
  {
    std::ostringstream message;
    message << "The field has " << field.size() << " values, expected one for each of the grid's "
            << expected << " samples (at least 1); compute the field on this grid.";
    throw InputError(message.str());
  }
}

void throwNotFinite(const std::array<int, 3>& lattice, double value)
{
  std::ostringstream message;
  message << "The field is " << value << " at sample (" << lattice[0] - 1 << ", " << lattice[1] - 1
          << ", " << lattice[2] - 1
          << ") of its extent, expected finite values; repair the field before this filter.";
  throw InputError(message.str());
}

/// Marks the outside samples that are joined to a first one, row by row along x.
class OutsideFlood
{
public:
  explicit OutsideFlood(const InsideSamples& samples)
    : Samples(samples)
    , Reached(static_cast<std::size_t>(samples.sampleCount()), 0)
  {
  }

  void run(GridIndex first)
  {
    this->Seeds.assign(1, first);
    while (!this->Seeds.empty())
    {
      const GridIndex seed = this->Seeds.back();
      this->Seeds.pop_back();
      if (this->isOpen(seed))
      {
        this->markRun(seed);
      }
    }
  }
  bool reached(GridIndex sample) const
  {
    return this->Reached[static_cast<std::size_t>(sample)] != 0;
  }

private:
  bool isOpen(GridIndex sample) const
  {
    return !this->Samples.isInside(sample) && !this->reached(sample);
  }

  /// Marks the seed's run of open samples and seeds the four rows beside it.
  void markRun(GridIndex seed)
  {
    const GridIndex rowBegin = seed - seed % this->Samples.size(0);
    const GridIndex rowEnd = rowBegin + this->Samples.size(0);
    GridIndex begin = seed;
    GridIndex end = seed + 1;
    while (begin > rowBegin && this->isOpen(begin - 1))
    {
      --begin;
    }
    while (end < rowEnd && this->isOpen(end))
    {
      ++end;
    }
    std::fill(this->Reached.begin() + begin, this->Reached.begin() + end, 1);
    const std::array<int, 3> lattice = this->Samples.lattice(seed);
    for (int axis = 1; axis < 3; ++axis)
    {
      const int position = lattice[static_cast<std::size_t>(axis)];
      const GridIndex stride = this->Samples.stride(axis);
      if (position > 0)
      {
        this->seedRow(begin - stride, end - stride);
      }
      if (position + 1 < this->Samples.size(axis))
      {
        this->seedRow(begin + stride, end + stride);
      }
    }
  }

  /// One seed for each run of open samples that begins in [begin, end).
  void seedRow(GridIndex begin, GridIndex end)
  {
    for (GridIndex sample = begin; sample < end; ++sample)
    {
      if (this->isOpen(sample) && (sample == begin || !this->isOpen(sample - 1)))
      {
        this->Seeds.push_back(sample);
      }
    }
  }

  const InsideSamples& Samples;
  std::vector<unsigned char> Reached;
  std::vector<GridIndex> Seeds;
};

} // namespace

InsideSamples::InsideSamples(const DistanceGrid& grid, const std::vector<float>& field,
  double isoValue, const Execution& execution)
  : Field(field)
  , IsoValue(isoValue)
{
  requireMatchingLength(grid, field);
  GridIndex stride = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Sizes[axis] = grid.dimension(static_cast<int>(axis)) + 2;
    this->Strides[axis] = stride;
    stride *= this->Sizes[axis];
  }
  for (unsigned b = 0; b < 8; ++b)
  {
    this->CornerOffsets[b] = this->sample(
      static_cast<int>(b & 1U), static_cast<int>(b >> 1U & 1U), static_cast<int>(b >> 2U));
  }
  this->Inside.assign(at(stride), 0);
  this->markBelow(execution);
}

void InsideSamples::markBelow(const Execution& execution)
{
  std::size_t next = 0;
  for (int k = 1; k + 1 < this->size(2); ++k)
  {
    execution.report(static_cast<double>(k) / this->size(2));
    for (int j = 1; j + 1 < this->size(1); ++j)
    {
      for (int i = 1; i + 1 < this->size(0); ++i)
      {
        const double value = this->Field[next++];
        if (!std::isfinite(value))
        {
          throwNotFinite({ i, j, k }, value);
        }
        this->Inside[at(this->sample(i, j, k))] = value < this->IsoValue ? 1 : 0;
      }
    }
  }
}

std::array<int, 3> InsideSamples::lattice(GridIndex sample) const
{
  return { static_cast<int>(sample % this->Strides[1]),
    static_cast<int>(sample % this->Strides[2] / this->Strides[1]),
    static_cast<int>(sample / this->Strides[2]) };
}

double InsideSamples::valueAboveIso(GridIndex sample) const
{
  const std::array<int, 3> position = this->lattice(sample);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (position[axis] < 1 || position[axis] + 2 > this->Sizes[axis])
    {
      return std::numeric_limits<double>::infinity();
    }
  }
  const GridIndex row =
    position[1] - 1 + static_cast<GridIndex>(this->Sizes[1] - 2) * (position[2] - 1);
  return this->Field[at(position[0] - 1 + (this->Sizes[0] - 2) * row)] - this->IsoValue;
}

GridIndex fillCavities(InsideSamples& samples, const Execution& execution)
{
  OutsideFlood flood(samples);
  flood.run(0);
  execution.report(0.5);
  GridIndex turned = 0;
  for (GridIndex sample = 0; sample < samples.sampleCount(); ++sample)
  {
    if (!samples.isInside(sample) && !flood.reached(sample))
    {
      samples.setInside(sample);
      ++turned;
    }
  }
  execution.report(1.0);
  return turned;
}

} // namespace evolving
