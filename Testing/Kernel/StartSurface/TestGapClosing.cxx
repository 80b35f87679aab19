// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/GapClosing.h"

#include "Mesh/Angles.h"
#include "Mesh/TopologySummary.h"
#include "Shapes/SampledOnGrid.h"
#include "StartSurface/GapShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

template <typename Distance>
std::vector<float> closed(
  const DistanceGrid& grid, const Distance& distance, double offset, double gapSize)
{
  return closeGaps(grid, sampled(grid, distance), offset, gapSize);
}

/// The value at the sample nearest to a point.
double valueAt(const DistanceGrid& grid, const std::vector<float>& field, const Vec3& point)
{
  const Vec3 s = (point - grid.origin).cwiseQuotient(grid.spacing).array().round();
  return field[static_cast<std::size_t>(
    grid.index(static_cast<int>(s.x()), static_cast<int>(s.y()), static_cast<int>(s.z())))];
}

/// Where the field falls below zero along z from above, at x = y = 0; linear between samples.
double heightAboveCentre(const DistanceGrid& grid, const std::vector<float>& field)
{
  const int middle = (grid.extent[1] - grid.extent[0]) / 2;
  const auto value = [&](int k)
  { return static_cast<double>(field[static_cast<std::size_t>(grid.index(middle, middle, k))]); };
  int k = grid.extent[5];
  while (k > grid.extent[4] && value(k - 1) >= 0.0)
  {
    --k;
  }
  const double part = value(k) / (value(k) - value(k - 1));
  return grid.point(middle, middle, k).z() - part * grid.spacing.z();
}

constexpr double Offset = 0.04;

} // namespace

TEST(GapClosing, LeavesASphereAsItIs)
{
  const auto sphere = [](const Vec3& p) { return std::abs(p.norm() - 0.5); };
  double lastError = 0.0;
  for (const int n : { 25, 49, 97 })
  {
    const DistanceGrid grid = cubicGrid(n);
    const SurfaceMesh surface = outerSurface(grid, closed(grid, sphere, 0.1, 0.5));
    double error = 0.0;
    for (const Vec3& point : surface.points)
    {
      error = std::max(error, std::abs(point.norm() - 0.6));
    }
    EXPECT_EQ(summarizeTopology(surface).genus(), 0);
    EXPECT_LT(error, 0.6 * grid.spacing.x());
    EXPECT_TRUE(n == 25 || lastError / error > 3.0) << lastError << " " << error;
    lastError = error;
  }
}

TEST(GapClosing, LeavesAConvexBoxAsItIs)
{
  const DistanceGrid grid = cubicGrid(81);
  const auto box = [](const Vec3& p)
  { return std::abs(boxDistance(p - Vec3(0.01, 0.02, 0.0), Vec3(0.5, 0.3, 0.4))); };
  const SurfaceMesh surface = outerSurface(grid, closed(grid, box, 0.05, 0.4));
  for (const Vec3& point : surface.points)
  {
    EXPECT_NEAR(box(point), 0.05, 0.6 * grid.spacing.x());
  }
  EXPECT_EQ(summarizeTopology(surface).genus(), 0);
}

TEST(GapClosing, ClosesSlotsNarrowerThanTheGapSize)
{
  const DistanceGrid grid = cubicGrid(81);
  for (const double width : { 0.15, 0.25, 0.35 })
  {
    const auto distance = [&](const Vec3& p) { return slotDistance(p, width); };
    const std::vector<float> field = closed(grid, distance, Offset, 0.3);
    const SurfaceMesh surface = outerSurface(grid, field);
    const bool isClosed = width < 0.3;
    EXPECT_EQ(valueAt(grid, field, Vec3::Zero()) < 0.0, isClosed) << width;
    EXPECT_EQ(summarizeTopology(surface).components, isClosed ? 1 : 2) << width;
    // Away from the slot the surface lies at its offset, corners and edges included.
    for (const Vec3& point : surface.points)
    {
      EXPECT_LT(distance(point), Offset + 0.6 * grid.spacing.x() + (isClosed ? 0.5 * width : 0.0));
      if (std::abs(point.x()) > 0.5 * width + 0.15 || !isClosed)
      {
        EXPECT_NEAR(distance(point), Offset, 0.6 * grid.spacing.x()) << width;
      }
    }
  }
}

TEST(GapClosing, AlwaysContainsTheOffset)
{
  const DistanceGrid grid = cubicGrid(41);
  for (const double width : { 0.15, 0.3, 0.45 })
  {
    const std::vector<float> distance =
      sampled(grid, [&](const Vec3& p) { return slotDistance(p, width); });
    const std::vector<float> field = closeGaps(grid, distance, Offset, 0.3);
    for (std::size_t s = 0; s < field.size(); ++s)
    {
      ASSERT_LE(field[s], static_cast<float>(distance[s] - Offset));
    }
  }
}

TEST(GapClosing, SpansASlotByTheBallThatRestsOnItsEdges)
{
  // The ball's centre is sqrt(r^2 - w^2 / 4) above the slot's mouth, the solid r - offset below it.
  constexpr double Width = 0.2;
  constexpr double Radius = 0.2;
  const double expected = 0.4 + std::sqrt(Radius * Radius - 0.25 * Width * Width) - Radius + Offset;
  for (const int n : { 41, 81, 121 })
  {
    const DistanceGrid grid = cubicGrid(n);
    const std::vector<float> field = closed(
      grid, [](const Vec3& p) { return slotDistance(p, Width); }, Offset, 2.0 * Radius);
    const double error = std::abs(heightAboveCentre(grid, field) - expected);
    EXPECT_LT(error, 0.4 * grid.spacing.x());
  }
}

TEST(GapClosing, ClosesAShellWhoseOpeningIsNarrower)
{
  const DistanceGrid grid = cubicGrid(81);
  constexpr double Angle = 0.3;
  const double opening = 2.0 * 0.5 * std::sin(Angle);
  const auto distance = [&](const Vec3& p) { return bowlDistance(p, Angle); };
  for (const double ratio : { 0.6, 0.8, 1.1, 1.3 })
  {
    const std::vector<float> field = closed(grid, distance, Offset, ratio * opening);
    const bool isClosed = ratio > 1.0;
    EXPECT_EQ(valueAt(grid, field, Vec3::Zero()) < 0.0, isClosed) << ratio;
    const SurfaceMesh surface = outerSurface(grid, field);
    EXPECT_EQ(summarizeTopology(surface).components, 1);
    EXPECT_EQ(summarizeTopology(surface).genus(), 0);
    const double ball = 4.0 / 3.0 * Pi * std::pow(0.5 + Offset, 3);
    EXPECT_EQ(signedVolume(surface) > 0.95 * ball, isClosed) << signedVolume(surface) / ball;
  }
}

TEST(GapClosing, ClosesATorussHoleWhenBallsFromBothSidesDoNotMeetInIt)
{
  // Resting on the hole, their centres are z = sqrt((r + 0.15)^2 - 0.4^2) above and below it, and
  // the solid is r - offset from there: it holds together when z > r - offset, from r = 0.366 on.
  const DistanceGrid grid = cubicGrid(81);
  const auto distance = [](const Vec3& p) { return std::abs(torusDistance(p, 0.4, 0.15)); };
  for (const double gapSize : { 0.3, 0.45, 0.68, 0.78 })
  {
    const std::vector<float> field = closed(grid, distance, Offset, gapSize);
    const TopologySummary summary = summarizeTopology(outerSurface(grid, field));
    EXPECT_EQ(summary.components, 1);
    EXPECT_EQ(summary.genus(), gapSize < 0.732 ? 1 : 0) << gapSize;
    EXPECT_EQ(valueAt(grid, field, Vec3::Zero()) < 0.0, gapSize > 0.732);
  }
}

TEST(GapClosing, ClosesAHoleThroughAThinSheetThatTheOffsetHoldsTogether)
{
  // Up to 2 sqrt(0.1 (0.5 - 0.1)) = 0.4, not up to the gap size.
  const DistanceGrid grid = cubicGrid(81);
  for (const double hole : { 0.34, 0.46 })
  {
    const auto distance = [&](const Vec3& p)
    {
      const double across = std::hypot(p.x(), p.y());
      return std::hypot(across - std::clamp(across, 0.5 * hole, 0.6), p.z());
    };
    const TopologySummary summary =
      summarizeTopology(outerSurface(grid, closed(grid, distance, 0.1, 0.5)));
    EXPECT_EQ(summary.genus(), hole < 0.4 ? 0 : 1) << hole;
  }
}

TEST(GapClosing, HasOnePartWhereTheBallJustPasses)
{
  // Whether it passes or not is a question of the grid; the inside must not be both.
  const DistanceGrid grid = cubicGrid(81);
  const auto distance = [](const Vec3& p) { return bowlDistance(p, 0.3); };
  for (double gapSize = 0.25; gapSize < 0.31; gapSize += 0.01)
  {
    const SurfaceMesh surface = outerSurface(grid, closed(grid, distance, Offset, gapSize));
    EXPECT_EQ(summarizeTopology(surface).components, 1) << gapSize;
    EXPECT_EQ(summarizeTopology(surface).genus(), 0) << gapSize;
  }
}
