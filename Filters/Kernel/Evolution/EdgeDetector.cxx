// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/EdgeDetector.h"

#include <utility>
#include <vector>

namespace evolving
{

ScalarImage edgeDetector(const ScalarImage& image, double sharpness, const Execution& execution)
{
  const DistanceGrid& grid = image.grid();
  const Extent& extent = grid.extent;
  std::vector<float> e(image.values().size());
  execution.forRangeReporting(grid.dimension(2), 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (int k = extent[4] + static_cast<int>(begin); k < extent[4] + static_cast<int>(end); ++k)
      {
        for (int j = extent[2]; j <= extent[3]; ++j)
        {
          for (int i = extent[0]; i <= extent[1]; ++i)
          {
            const double slope = image.gradientAtSample(i, j, k).squaredNorm();
            e[static_cast<std::size_t>(grid.index(i, j, k))] =
              static_cast<float>(1.0 / (1.0 + sharpness * slope));
          }
        }
      }
    });
  return ScalarImage(grid, std::move(e), image.axes());
}

EdgeSample sampleEdgeDetector(const ScalarImage& e, const Vec3& point)
{
  const DistanceGrid& grid = e.grid();
  const Vec3 low = grid.point(grid.extent[0], grid.extent[2], grid.extent[4]);
  const Vec3 high = grid.point(grid.extent[1], grid.extent[3], grid.extent[5]);
  const Vec3 own = e.axes().pointFromWorld(point);
  const Vec3 closest = own.cwiseMax(low).cwiseMin(high);
  EdgeSample sample{ e.atOwnPoint(closest) };
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    // An axis of one sample has no outside.
    if (low[axis] != high[axis] && closest[axis] != own[axis])
    {
      sample.gradient.setZero();
      sample.isOutside = true;
    }
  }
  sample.gradient = e.axes().vectorToWorld(sample.gradient);
  return sample;
}

} // namespace evolving
