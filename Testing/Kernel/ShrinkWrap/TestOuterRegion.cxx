// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Shapes/Draws.h"
#include "ShrinkWrap/OuterRegion.h"

#include "Evolution/EvolutionFields.h"
#include "Mesh/Angles.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/TopologySummary.h"
#include "Shapes/SampledOnGrid.h"
#include "ThreadedExecution.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace
{

using namespace evolving;

using namespace evolving::shapes;

constexpr double Radius = 0.2;

OuterRegion regionAround(
  const std::function<double(const Vec3&)>& distance, const Execution& execution = {})
{
  const DistanceGrid grid = shapes::cubicGrid(49, 1.8);
  return OuterRegion(
    grid, sampled(grid, [&](const Vec3& p) { return distance(p) - Radius; }), Radius, execution);
}

double fromShell(const Vec3& point)
{
  return std::abs(point.norm() - 1.0);
}

/// Of a unit sphere with a round hole at the pole that is seen from the centre under an angle.
std::function<double(const Vec3&)> fromDrilledShell(double angle)
{
  return [angle](const Vec3& p)
  {
    const double polar = std::acos(p.z() / std::max(1e-12, p.norm()));
    const Vec3 rim =
      Vec3(p.x(), p.y(), 0.0).normalized() * std::sin(angle) + std::cos(angle) * Vec3::UnitZ();
    return polar > angle ? fromShell(p) : (p - rim).norm();
  };
}

TEST(OuterRegion, OfAShellIsWhatIsOutside)
{
  const OuterRegion region = regionAround(fromShell);
  const SurfaceMesh surface = region.boundary();
  const TopologySummary topology = summarizeTopology(surface);
  EXPECT_EQ(topology.components, 1);
  EXPECT_TRUE(topology.isClosed() && topology.isManifold() && topology.isOriented());
  EXPECT_EQ(topology.genus(), 0);
  EXPECT_GT(signedVolume(surface), 0.0);
  EXPECT_TRUE(selfIntersections(surface).empty());
  for (const Vec3& p : surface.points)
  {
    EXPECT_NEAR(p.norm(), 1.0 + Radius, 0.01); // cells are 0.075
  }
}

TEST(OuterRegion, ReachabilityGoesFromZeroToOneAcrossTheBallsCentres)
{
  const OuterRegion region = regionAround(fromShell);
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i)
  {
    const Vec3 way = shapes::drawnVector(normal, generator).normalized();
    EXPECT_EQ(region.reachable(1.3 * way), 1.0);
    EXPECT_NEAR(region.reachable(1.2 * way), 0.5, 0.1);
    EXPECT_EQ(region.reachable(1.1 * way), 0.0);
    EXPECT_FALSE(region.isFarFrom(1.2 * way));
    // The cavity is as far from the shell as the outside is, and yet out of reach.
    EXPECT_EQ(region.reachable(0.5 * way), 0.0);
    EXPECT_TRUE(region.isFarFrom(0.5 * way));
  }
}

TEST(OuterRegion, TheBallEntersAHoleThatIsWiderThanItself)
{
  // The hole's radius is sin(angle): the ball of 0.2 passes 0.3 and not 0.1.
  const OuterRegion wide = regionAround(fromDrilledShell(std::asin(0.3)));
  EXPECT_EQ(wide.reachable(Vec3::Zero()), 1.0);
  const SurfaceMesh bowl = wide.boundary();
  EXPECT_EQ(summarizeTopology(bowl).components, 1);
  EXPECT_EQ(summarizeTopology(bowl).genus(), 0);
  const double shell = 4.0 / 3.0 * Pi * (std::pow(1.2, 3) - std::pow(0.8, 3));
  EXPECT_LT(signedVolume(bowl), shell);
  EXPECT_GT(signedVolume(bowl), 0.9 * shell);
  const OuterRegion narrow = regionAround(fromDrilledShell(std::asin(0.1)));
  EXPECT_EQ(narrow.reachable(Vec3::Zero()), 0.0);
  EXPECT_TRUE(narrow.isFarFrom(Vec3::Zero()));
}

TEST(OuterRegion, ContainsTheSamplesThatAreReachable)
{
  const OuterRegion region = regionAround(fromShell);
  const DistanceGrid grid = shapes::cubicGrid(49, 1.8);
  for (int k = 0; k < 49; ++k)
  {
    for (int i = 0; i < 49; ++i)
    {
      const Vec3 p = grid.point(i, 24, k);
      const auto number = static_cast<std::size_t>(grid.index(i, 24, k));
      const bool isNear = std::abs(p.norm() - 0.8) < 0.1; // the filled cavity's margin
      EXPECT_TRUE(isNear || region.contains(number) == (p.norm() > 1.0 + Radius)) << p.norm();
    }
  }
}

TEST(OuterRegion, SpecksDropOut)
{
  // Two spheres, one of them no larger than three cells with the ball around.
  const auto distance = [](const Vec3& p)
  { return std::min((p + Vec3(0.5, 0, 0)).norm() - 0.5, (p - Vec3(1.2, 0, 0)).norm() + 0.15); };
  const SurfaceMesh surface = regionAround(distance).boundary();
  EXPECT_EQ(summarizeTopology(surface).components, 1);
  EXPECT_LT(boundingBox(surface).max().x(), 0.3);
  // When there is nothing else they stay.
  const auto speck = [](const Vec3& p) { return p.norm() + 0.1; };
  EXPECT_GT(regionAround(speck).boundary().faceCount(), 0);
}

TEST(OuterRegion, IsTheSameOnAnyThreads)
{
  const auto distance = fromDrilledShell(std::asin(0.3));
  const SurfaceMesh serial = regionAround(distance).boundary();
  for (const int threads : { 2, 4 })
  {
    const Execution host = threadedExecution(threads, 3);
    EXPECT_TRUE(regionAround(distance, host).boundary(host) == serial);
  }
}

} // namespace
