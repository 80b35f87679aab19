// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapTarget.h"

#include "Errors.h"
#include "Mesh/Angles.h"
#include "Mesh/TopologySummary.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/HoleyShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Spheres.h"
#include "ShrinkWrap/OuterRegion.h"
#include "ShrinkWrap/WrapRuns.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace evolving;
using namespace evolving::shapes;

/// How well the start comes to the origin: 0 or 1.
double reachesOrigin(const SurfaceMesh& mesh, const ShrinkWrapOptions& options)
{
  const auto [target, fields] = wraps::describe(mesh, options, {});
  const OuterRegion region(target.grid, fields.start, target.startLevel);
  return region.reachable(Vec3::Zero());
}

TEST(WrapTarget, LengthsFollowFromTheOptions)
{
  ShrinkWrapOptions options = wraps::quick(0.2);
  options.offsetDistance = 0.3;
  const WrapTarget target = wraps::describe(icosphere(4), options, {}).target;
  EXPECT_NEAR(target.area, 4.0 * Pi, 0.04);
  EXPECT_EQ(target.edgeLength, 0.2);
  const TargetTuning tuning;
  EXPECT_NEAR(target.wall, tuning.wallPerEdge * 0.2, 1e-15);
  EXPECT_EQ(target.offset, 0.3);
  EXPECT_NEAR(target.startLevel, 0.3 + tuning.startPerEdge * 0.2, 1e-15);
  // Else the start level would follow from the cells.
  EXPECT_LT(tuning.startPerCell * target.cellSize(), tuning.startPerEdge * 0.2);
  options.sampleDimensions = { 16, 16, 16 };
  const WrapTarget coarse = wraps::describe(icosphere(4), options, {}).target;
  EXPECT_NEAR(coarse.startLevel, 0.3 + tuning.startPerCell * coarse.cellSize(), 1e-15);
  options.targetEdgeLength = 0.0;
  EXPECT_EQ(wraps::describe(icosphere(4), options, {}).target.edgeLength,
    defaultEdgeLength(target.area, target.box.diagonal().norm()));
}

TEST(WrapTarget, DistancesAreThoseOfTheSurface)
{
  const auto [target, fields] = wraps::describe(icosphere(4), wraps::quick(), {});
  for (int k = 0; k < target.grid.dimension(2); k += 3)
  {
    for (int i = 0; i < target.grid.dimension(0); i += 3)
    {
      const auto sample = static_cast<std::size_t>(target.grid.index(i, 17, k));
      const double radius = target.grid.point(i, 17, k).norm();
      const double distance = std::abs(radius - 1.0);
      const double needed = 2.0 * target.edgeLength; // beyond they need not be exact
      EXPECT_LT(fields.distance[sample], distance + 0.003);
      EXPECT_GT(fields.distance[sample], std::min(distance, needed) - 0.003);
      EXPECT_TRUE(std::abs(radius - 1.0) < 0.003 || fields.isInside[sample] == (radius < 1.0));
    }
  }
}

TEST(WrapTarget, HolesOfAScanAreFilledAndOpeningsAreNot)
{
  const SurfaceMesh scan = drilledSphere({ Vec3::UnitX(), Vec3::UnitZ() }, 0.15);
  ASSERT_FALSE(summarizeTopology(scan).isClosed());
  const WrapTarget filled = wraps::describe(scan, wraps::quick(0.02), {}).target;
  EXPECT_TRUE(summarizeTopology(filled.surface).isClosed());
  EXPECT_NEAR(filled.area, 4.0 * Pi, 0.4);
  const SurfaceMesh bowl = drilledSphere({ Vec3::UnitZ() }, 1.0);
  EXPECT_FALSE(
    summarizeTopology(wraps::describe(bowl, wraps::quick(), {}).target.surface).isClosed());
  // Its mouth is 2 sin(1) = 1.68 wide.
  ShrinkWrapOptions options = wraps::quick();
  options.gapSize = 1.5;
  EXPECT_FALSE(summarizeTopology(wraps::describe(bowl, options, {}).target.surface).isClosed());
  options.gapSize = 1.9;
  EXPECT_TRUE(summarizeTopology(wraps::describe(bowl, options, {}).target.surface).isClosed());
}

/// A unit sphere without what lies within half a width of its equator's plane.
SurfaceMesh crackedSphere(double width)
{
  const SurfaceMesh half = shapes::halfSphere(24);
  const Vec3 up(0.0, 0.0, 0.5 * width);
  return shapes::merged(
    shapes::transformed(half, 1.0, up), shapes::transformed(reversed(half), -1.0, -up));
}

TEST(WrapTarget, CracksCloseUpToTwoEdgesWiderThanTheStartLevelCloses)
{
  // Cracks of twice the start level close by it, wider ones by the search.
  const double edge = 0.1;
  const ShrinkWrapOptions automatic = wraps::quick(edge, 64);
  const TargetTuning tuning;
  const double widest = (2.0 * tuning.startPerEdge + tuning.largestCrackEdges) * edge;
  for (const double part : { 0.2, 0.4, 0.6, 0.8 })
  {
    EXPECT_EQ(reachesOrigin(crackedSphere(part * widest), automatic), 0.0) << part;
  }
  EXPECT_EQ(reachesOrigin(crackedSphere(1.5 * widest), automatic), 1.0);
  // A gap size says so itself.
  ShrinkWrapOptions options = automatic;
  options.gapSize = 2.0 * widest;
  EXPECT_EQ(reachesOrigin(crackedSphere(1.5 * widest), options), 0.0);
  options.gapSize = 0.4 * widest;
  EXPECT_EQ(reachesOrigin(crackedSphere(0.8 * widest), options), 1.0);
}

TEST(WrapTarget, StartFieldIsZeroAtTheStartLevel)
{
  const auto [target, fields] = wraps::describe(icosphere(4), wraps::quick(), {});
  for (int i = 0; i < target.grid.dimension(0); ++i)
  {
    const auto sample = static_cast<std::size_t>(target.grid.index(i, 18, 18));
    const double beyond = target.grid.point(i, 18, 18).norm() - 1.0 - target.startLevel;
    if (std::abs(beyond) < 1.5 * target.cellSize())
    {
      EXPECT_NEAR(fields.start[sample], beyond, 0.02);
    }
  }
}

TEST(WrapTarget, RefusesWhatHasNoArea)
{
  SurfaceMesh needle;
  needle.points = { Vec3::Zero(), Vec3::UnitX(), 2.0 * Vec3::UnitX() };
  needle.addFace({ 0, 1, 2 });
  EXPECT_THROW(wraps::describe(needle, wraps::quick(0.0), {}), InputError);
  const Execution stopped(nullptr, nullptr, [] { return true; });
  EXPECT_THROW(wraps::describe(icosphere(3), wraps::quick(), stopped), Cancelled);
}

} // namespace
