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

float shifted(float value, double shift)
{
  return static_cast<float>(value + shift);
}

std::vector<float> shifted(std::vector<float> values, double shift)
{
  for (float& value : values)
  {
    value = shifted(value, shift);
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

/// The field is distance - offset, or where that is lower depth - distance to the boundary at the
/// samples inside and depth + that outside; it takes the place of the distance to the boundary.
void fillField(std::vector<float>& toBoundary, const DistanceGrid& grid,
  const InsideSamples& inside, const std::vector<float>& distance, double offset, double depth,
  const Execution& execution)
{
  const GridIndex width = grid.dimension(0);
  const GridIndex height = grid.dimension(1);
  const auto fillRow = [&](GridIndex row)
  {
    const GridIndex first =
      inside.sample(1, static_cast<int>(row % height) + 1, static_cast<int>(row / height) + 1);
    for (GridIndex i = 0; i < width; ++i)
    {
      const auto s = static_cast<std::size_t>(row * width + i);
      const double side = inside.isInside(first + i) ? -1.0 : 1.0;
      toBoundary[s] = static_cast<float>(
        std::min<double>(shifted(distance[s], -offset), depth + side * toBoundary[s]));
    }
  };
  execution.forRange(height * grid.dimension(2), RowGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t row = begin; row < end; ++row)
      {
        fillRow(row);
      }
    });
}

} // namespace

std::vector<float> closeGaps(const DistanceGrid& grid, const std::vector<float>& distance,
  double offset, double gapSize, const Execution& execution)
{
  requireLength("offset", offset);
  requireLength("gap size", gapSize);
  const double depth = 0.5 * gapSize - offset;
  if (depth <= 0.0)
  {
    return shifted(distance, -offset);
  }
  const InsideSamples inside = notReached(grid, distance, 0.5 * gapSize, execution.phase(0.0, 0.3));
  std::vector<float> field = distanceToBoundary(grid, inside, depth, execution.phase(0.3, 0.95));
  if (field.empty())
  {
    return shifted(distance, -offset);
  }
  fillField(field, grid, inside, distance, offset, depth, execution);
  execution.report(1.0);
  return field;
}

} // namespace evolving
