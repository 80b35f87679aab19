// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// The numbers of a state whose points are handed out elsewhere, as floats.

#include "Evolution/EvolutionFields.h"
#include "Evolution/FlowRuns.h"
#include "Evolution/StateSeries.h"
#include "Evolution/SurfaceFlow.h"
#include "Mesh/MeshQuality.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace evolving;

namespace
{

SurfaceFlow exampleFlow(int steps)
{
  return SurfaceFlow(
    shapes::bumpySphere(2), shapes::sphereField(33, 1.6, 0.5), flows::towardsSphere(steps));
}

} // namespace

TEST(HandedOutRecords, WhereTheStateIsTheyAreItsOwn)
{
  SurfaceFlow flow = exampleFlow(3);
  flows::run(flow);
  const FlowRecord& own = flow.record();
  const FlowRecord same = flow.recordAt(flow.mesh().points);
  EXPECT_EQ(same.iteration, own.iteration);
  EXPECT_EQ(same.time, own.time);
  EXPECT_NEAR(same.area, own.area, 1e-14 * own.area); // summed in another order
  EXPECT_EQ(same.volume, own.volume);
  EXPECT_EQ(same.minAngle, own.minAngle);
  EXPECT_EQ(same.meanDistance, own.meanDistance);
  EXPECT_EQ(same.maxDistance, own.maxDistance);
}

TEST(HandedOutRecords, ElsewhereTheyAreMeasuredThere)
{
  SurfaceFlow flow = exampleFlow(0);
  SurfaceMesh mesh = flow.mesh();
  for (Vec3& point : mesh.points)
  {
    point = 0.8 * point + Vec3(0.0, 0.0, 0.2 * point.x());
  }
  const FlowRecord record = flow.recordAt(mesh.points);
  EXPECT_NEAR(record.area, surfaceArea(mesh), 1e-12);
  EXPECT_NEAR(record.volume, signedVolume(mesh), 1e-12);
  EXPECT_EQ(record.minAngle, smallestAngle(mesh));
  // Of the arrays, which are handed out with them.
  double largest = 0.0;
  for (const double distance : flow.arrays().distance)
  {
    largest = std::max(largest, std::abs(distance));
  }
  EXPECT_EQ(record.maxDistance, largest);
  EXPECT_EQ(record.meanDistance, flow.record().meanDistance);
  EXPECT_NE(record.area, flow.record().area);
}

TEST(HandedOutRecords, ASeriesShowsEveryStep)
{
  std::vector<FlowRecord> seen;
  const auto observe = [&seen](const SurfaceFlow& flow) { seen.push_back(flow.record()); };
  const StateSeries series([](const Execution&) { return exampleFlow(7); },
    publishedIterations(7, 0, 3), std::size_t(1) << 30, Execution(), 0, observe);
  ASSERT_EQ(seen.size(), 8u);
  ASSERT_EQ(series.history().size(), 8u);
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    EXPECT_EQ(seen[i].iteration, static_cast<int>(i));
    EXPECT_EQ(seen[i].area, series.history()[i].area);
  }
}
