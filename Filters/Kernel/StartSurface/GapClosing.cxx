// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/GapClosing.h"

#include "Distance/SignedDistance.h"
#include "Errors.h"
#include "StartSurface/InsideSamples.h"
#include "StartSurface/QuadSplitting.h"
#include "StartSurface/SurfaceNets.h"
#include "StartSurface/WellComposed.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace evolving
{

namespace
{

constexpr std::int64_t RowGrain = 256;

void requireLength(const char* name, double length)
{
  if (!std::isfinite(length) || length < 0.0)
  {
    std::ostringstream message;
    message << "The " << name << " is " << length
            << ", expected a finite length of at least 0; set 0 for none.";
    throw InputError(message.str());
  }
}

std::vector<float> shifted(std::vector<float> values, double shift)
{
  for (float& value : values)
  {
    value = static_cast<float>(value + shift);
  }
  return values;
}

/// The samples that no ball's centre reaches: nearer to the surface than the radius, or shut off.
InsideSamples notReached(const DistanceGrid& grid, const std::vector<float>& distance,
  double radius, const Execution& execution)
{
  InsideSamples samples(grid, distance, radius, execution.phase(0.0, 0.2));
  makeWellComposed(samples, execution.phase(0.2, 0.8));
  fillCavities(samples, execution.phase(0.8, 1.0));
  return samples;
}

/// The distance to the boundary of those samples, as far as it matters.
std::vector<float> distanceToBoundary(
  const DistanceGrid& grid, const InsideSamples& samples, double depth, const Execution& execution)
{
  // The grid's cells beside the new surface have samples up to the root of 3 cells away from it.
  constexpr double CellsBeyond = 2.0;
  const SurfaceMesh boundary =
    splitQuads(surfaceNet(grid, samples, execution.phase(0.0, 0.3)).mesh);
  if (boundary.faceCount() == 0)
  {
    return {};
  }
  SignedDistanceOptions options;
  options.sign = SignMethod::Unsigned;
  options.bandWidth = depth / grid.spacing.minCoeff() + CellsBeyond;
  return signedDistance(boundary, grid, grid.extent, options, execution.phase(0.3, 1.0)).distance;
}

/// Lowers the field to depth - distance at the samples inside, and to depth + distance outside,
/// where that is lower. The boundary has the samples on the sides they are known to be on.
void lowerTo(std::vector<float>& field, const DistanceGrid& grid, const InsideSamples& inside,
  const std::vector<float>& toBoundary, double depth, const Execution& execution)
{
  const GridIndex width = grid.dimension(0);
  const GridIndex height = grid.dimension(1);
  const auto lowerRow = [&](GridIndex row)
  {
    const GridIndex first =
      inside.sample(1, static_cast<int>(row % height) + 1, static_cast<int>(row / height) + 1);
    for (GridIndex i = 0; i < width; ++i)
    {
      const auto s = static_cast<std::size_t>(row * width + i);
      const double side = inside.isInside(first + i) ? -1.0 : 1.0;
      field[s] = static_cast<float>(std::min<double>(field[s], depth + side * toBoundary[s]));
    }
  };
  execution.forRange(height * grid.dimension(2), RowGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t row = begin; row < end; ++row)
      {
        lowerRow(row);
      }
    });
}

} // namespace

std::vector<float> closeGaps(const DistanceGrid& grid, const std::vector<float>& distance,
  double offset, double gapSize, const Execution& execution)
{
  requireLength("offset", offset);
  requireLength("gap size", gapSize);
  std::vector<float> field = shifted(distance, -offset);
  const double depth = 0.5 * gapSize - offset;
  if (depth <= 0.0)
  {
    return field;
  }
  const InsideSamples inside = notReached(grid, distance, 0.5 * gapSize, execution.phase(0.0, 0.3));
  const std::vector<float> toBoundary =
    distanceToBoundary(grid, inside, depth, execution.phase(0.3, 0.95));
  if (!toBoundary.empty())
  {
    lowerTo(field, grid, inside, toBoundary, depth, execution);
  }
  execution.report(1.0);
  return field;
}

} // namespace evolving
