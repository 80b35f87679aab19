// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/GapClosing.h"

#include "Errors.h"
#include "Shapes/SampledOnGrid.h"
#include "StartSurface/GapShapes.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

constexpr double Offset = 0.04;

} // namespace

TEST(GapClosing, IsTheOffsetForSmallGapSizes)
{
  const DistanceGrid grid = cubicGrid(21);
  const std::vector<float> distance =
    sampled(grid, [](const Vec3& p) { return slotDistance(p, 0.2); });
  for (const double gapSize : { 0.0, 0.1, 0.2 })
  {
    const std::vector<float> field = closeGaps(grid, distance, 0.1, gapSize);
    for (std::size_t s = 0; s < field.size(); ++s)
    {
      ASSERT_EQ(field[s], static_cast<float>(distance[s] - 0.1));
    }
  }
  // Nothing is near: nothing to close.
  const std::vector<float> far(distance.size(), 5.0F);
  EXPECT_EQ(closeGaps(grid, far, 1.0, 4.0), std::vector<float>(distance.size(), 4.0F));
}

TEST(GapClosing, TakesDistancesWithSignsToo)
{
  const DistanceGrid grid = cubicGrid(41);
  std::vector<float> distance =
    sampled(grid, [](const Vec3& p) { return torusDistance(p, 0.4, 0.15); });
  // The offset is wider than a cell, so that no sample inside is beside the surface.
  const SurfaceMesh signedOne = outerSurface(grid, closeGaps(grid, distance, 0.1, 0.4));
  for (float& value : distance)
  {
    value = std::abs(value);
  }
  const SurfaceMesh unsignedOne = outerSurface(grid, closeGaps(grid, distance, 0.1, 0.4));
  EXPECT_EQ(signedOne.points, unsignedOne.points);
}

TEST(GapClosing, HasTheSameBitsForAnyNumberOfThreads)
{
  const DistanceGrid grid = cubicGrid(45);
  const std::vector<float> distance =
    sampled(grid, [](const Vec3& p) { return bowlDistance(p, 0.3); });
  const std::vector<float> serial = closeGaps(grid, distance, Offset, 0.4);
  for (const int threads : { 2, 3 })
  {
    EXPECT_EQ(closeGaps(grid, distance, Offset, 0.4, threadedExecution(threads, 7)), serial);
  }
}

TEST(GapClosing, RefusesBadLengthsAndFields)
{
  const DistanceGrid grid = cubicGrid(4);
  const std::vector<float> field(64, 1.0F);
  EXPECT_THROW(closeGaps(grid, field, -0.1, 0.3), InputError);
  EXPECT_THROW(closeGaps(grid, field, 0.1, -0.3), InputError);
  EXPECT_THROW(closeGaps(grid, field, 0.1, std::numeric_limits<double>::quiet_NaN()), InputError);
  EXPECT_THROW(closeGaps(grid, std::vector<float>(63, 1.0F), 0.1, 0.3), InputError);
}

TEST(GapClosing, StopsWhenAsked)
{
  const DistanceGrid grid = cubicGrid(21);
  const std::vector<float> distance =
    sampled(grid, [](const Vec3& p) { return bowlDistance(p, 0.3); });
  const auto serial = [](std::int64_t count, const std::function<void(std::int64_t)>& task)
  {
    for (std::int64_t i = 0; i < count; ++i)
    {
      task(i);
    }
  };
  double last = 0.0;
  const auto record = [&](double fraction)
  {
    EXPECT_GE(fraction, last);
    last = fraction;
  };
  closeGaps(grid, distance, Offset, 0.4, Execution(serial, record, [] { return false; }));
  EXPECT_EQ(last, 1.0);
  last = 0.0;
  const auto stop = [&] { return last > 0.5; };
  EXPECT_THROW(closeGaps(grid, distance, Offset, 0.4, Execution(serial, record, stop)), Cancelled);
}
