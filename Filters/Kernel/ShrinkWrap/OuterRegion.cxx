// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/OuterRegion.h"

#include "StartSurface/InsideSamples.h"
#include "StartSurface/Isosurface.h"
#include "StartSurface/SurfaceComponents.h"

#include <algorithm>
#include <utility>

namespace evolving
{

namespace
{

/// From unreachable to reachable over this difference in height: a radius is 0.8 cells and more, so
/// it takes a sixth of a cell at least, and levels between do not jump.
constexpr double SlopeRadii = 0.2;
/// All samples around a lower point are ones that the ball does not come near to, at height -1; the
/// rest is rounding, and where one corner of the cell hardly counts.
constexpr double DeepRadii = -0.95;

/// Is a sample, or one of the 26 around it, outside?
bool isNearOutside(const InsideSamples& samples, int i, int j, int k)
{
  for (int dk = -1; dk <= 1; ++dk)
  {
    for (int dj = -1; dj <= 1; ++dj)
    {
      for (int di = -1; di <= 1; ++di)
      {
        if (!samples.isInside(samples.sample(i + di, j + dj, k + dk)))
        {
          return true;
        }
      }
    }
  }
  return false;
}

/// The field, and -radius at the samples that the ball cannot even come near to.
std::vector<float> reachableHeights(const DistanceGrid& grid, const std::vector<float>& field,
  double radius, const Execution& execution)
{
  InsideSamples samples(grid, field, 0.0, execution.phase(0.0, 0.4));
  fillCavities(samples, execution.phase(0.4, 0.8));
  std::vector<float> heights = field;
  execution.forRange(samples.size(2) - 2, 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (int k = static_cast<int>(begin) + 1; k <= static_cast<int>(end); ++k)
      {
        for (int j = 1; j + 1 < samples.size(1); ++j)
        {
          for (int i = 1; i + 1 < samples.size(0); ++i)
          {
            if (!isNearOutside(samples, i, j, k))
            {
              heights[static_cast<std::size_t>(grid.index(i - 1, j - 1, k - 1))] =
                -static_cast<float>(radius);
            }
          }
        }
      }
    });
  return heights;
}

} // namespace

OuterRegion::OuterRegion(
  const DistanceGrid& grid, std::vector<float> field, double radius, const Execution& execution)
  : Grid(grid)
  , Field(std::move(field))
  , Radius(radius)
  , Height(grid, reachableHeights(grid, this->Field, radius, execution))
{
}

SurfaceMesh OuterRegion::boundary(const Execution& execution) const
{
  IsosurfaceOptions options;
  options.fillCavities = true;
  options.relaxationSweeps = 2;
  const SurfaceMesh surface = isosurface(this->Grid, this->Field, options, execution);
  SurfaceMesh kept = dropSmallComponents(surface, SpeckCells * this->Grid.spacing.maxCoeff());
  return kept.faceCount() > 0 ? kept : surface;
}

double OuterRegion::reachable(const Vec3& point) const
{
  const double height = this->Height.at(point).value;
  return std::clamp(0.5 + height / (SlopeRadii * this->Radius), 0.0, 1.0);
}

bool OuterRegion::isFarFrom(const Vec3& point) const
{
  return this->Height.at(point).value < DeepRadii * this->Radius;
}

} // namespace evolving
