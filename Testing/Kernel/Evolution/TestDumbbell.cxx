// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// A dumbbell under mean curvature flow: its neck goes first, and both ends go on as they are.

#include "Evolution/FlowRuns.h"
#include "Evolution/SurfaceRemesher.h"
#include "Mesh/MeshTopology.h"
#include "Operators/EnclosedVolume.h"
#include "Shapes/Spheres.h"
#include "VolumeFlows/VolumeFlowRuns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;

namespace
{

/// Two balls of radius 1 or so around x = -2 and 2, and a neck of a fifth of that.
SurfaceMesh dumbbell(int level)
{
  SurfaceMesh mesh = shapes::unitIcosphere(level);
  for (Vec3& p : mesh.points)
  {
    const double squared = p.x() * p.x();
    const double width = 0.2 + 3.2 * squared * (1.0 - 0.5 * squared);
    p = Vec3(3.0 * p.x(), width * p.y(), width * p.z());
  }
  return mesh;
}

/// The largest distance from the axis of what is near a place on it; 0 where nothing is.
double thickness(const SurfaceMesh& mesh, double from, double to)
{
  double thickest = 0.0;
  for (const Vec3& p : mesh.points)
  {
    if (from <= p.x() && p.x() <= to)
    {
      thickest = std::max(thickest, p.tail<2>().norm());
    }
  }
  return thickest;
}

} // namespace

TEST(Dumbbell, PinchesItsNeckFirstAndEndsWell)
{
  FlowOptions options = flows::meanCurvatureFlow(2e-3, 1000);
  options.redistribution.volume = 1.0;
  SurfaceFlow flow = flows::remeshed(dumbbell(4), options);
  bool hasParted = false;
  while (!flow.isFinished())
  {
    flow.step();
    EXPECT_TRUE(flow.record().isRedistributed);
    if (!hasParted && MeshTopology(flow.mesh()).componentCount() == 2)
    {
      hasParted = true;
      EXPECT_EQ(thickness(flow.mesh(), -0.05, 0.05), 0.0);
      EXPECT_GT(thickness(flow.mesh(), -3.0, -0.5), 0.3);
      EXPECT_GT(thickness(flow.mesh(), 0.5, 3.0), 0.3);
    }
  }
  EXPECT_TRUE(hasParted);
  EXPECT_EQ(flow.stopReason(), "");
  EXPECT_TRUE(flow.extinctionTime().has_value());
  EXPECT_GT(flow.record().minAngle, 15.0);
}

TEST(Dumbbell, EndsWellWithTheElementsItHas)
{
  FlowOptions options = flows::meanCurvatureFlow(2e-3, 1000);
  options.redistribution.volume = 1.0;
  SurfaceFlow flow(dumbbell(3), nullptr, options);
  flows::run(flow);
  EXPECT_EQ(flow.stopReason(), "");
  EXPECT_TRUE(flow.extinctionTime().has_value());
}

TEST(Dumbbell, SharesItsVolumeOutWhenItPartsAlthoughThatIsHeld)
{
  SurfaceFlow flow = flows::remeshed(dumbbell(4), flows::volumePreserving(150, 4e-3));
  const flows::Ledger ledger = flows::runWithLedger(flow);
  EXPECT_LT(ledger.volumeDrift, 1e-11);
  const std::vector<double> volumes = componentVolumes(flow.mesh(), MeshTopology(flow.mesh()));
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes[0] / volumes[1], 1.0, 0.02);
}
