// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCapture/CaptureShapes.h"
#include "FeatureCapture/FeatureCoverage.h"
#include "FeatureCapture/FeatureReference.h"
#include "Mesh/Angles.h"
#include "Mesh/MeshQuality.h"
#include "Remeshing/EditingChecks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace
{

using namespace evolving;
using namespace evolving::capture;

/// Vertices on creases that are corners of a triangle with a smaller angle.
std::set<Index> wanted(const EditableSurface& surface, double degrees)
{
  std::set<Index> vertices;
  const SurfaceMesh mesh = surface.mesh();
  for (Index f = 0; f < mesh.faceCount(); ++f)
  {
    for (Index k = 0; smallestAngle(mesh, f) < degrees && k < 3; ++k)
    {
      const Index v = mesh.faceVertex(f, k);
      if (surface.featureEdges(v) > 0)
      {
        vertices.insert(v);
      }
    }
  }
  return vertices;
}

/// A wedge just captured: some bad elements.
EditableSurface captureOfWedge(const TargetFeatures& features)
{
  EditableSurface surface = captured(creasedShapes()[1], features);
  surface.compact();
  return surface;
}

TEST(FeatureRelease, FreesTheCornersOfBadTrianglesAndNothingElse)
{
  const TargetFeatures features = featuresOf(creasedShapes()[1]);
  const EditableSurface before = captureOfWedge(features);
  for (const double degrees : { 12.0, 18.0, 24.0 })
  {
    const std::set<Index> free = wanted(before, degrees);
    ASSERT_GE(free.size(), 2u) << degrees;
    EditableSurface after = before;
    const std::vector<Index> cramped = crampedFeatures(after, degrees);
    EXPECT_EQ(cramped, std::vector<Index>(free.begin(), free.end()));
    releaseFeatures(after, cramped);
    EXPECT_TRUE(after.mesh() == before.mesh());
    for (const Index v : editing::verticesOf(before))
    {
      ASSERT_EQ(after.isPinned(v), before.isPinned(v) && free.count(v) == 0);
    }
    for (const Index e : editing::edgesOf(before))
    {
      const bool isFree = free.count(before.from(e)) + free.count(before.to(e)) > 0;
      ASSERT_EQ(after.curve(e), isFree ? NoIndex : before.curve(e));
    }
    for (const Index f : editing::facesOf(before))
    {
      const bool isFree = free.count(before.from(3 * f)) + free.count(before.from(3 * f + 1)) +
          free.count(before.from(3 * f + 2)) >
        0;
      ASSERT_EQ(after.label(f), isFree ? FeatureReference::NoPatch : before.label(f));
    }
  }
}

TEST(FeatureRelease, IsSeenByTheCoverage)
{
  const TargetFeatures features = featuresOf(creasedShapes()[1]);
  EditableSurface surface = captureOfWedge(features);
  double unmarked = 0.0;
  const std::set<Index> free = wanted(surface, 15.0);
  for (const Index e : editing::edgesOf(surface))
  {
    const bool isFree = free.count(surface.from(e)) + free.count(surface.to(e)) > 0;
    unmarked += isFree && surface.curve(e) != NoIndex ? 0.5 * surface.length(e) : 0.0;
  }
  ASSERT_GT(unmarked, 0.1);
  releaseFeatures(surface, crampedFeatures(surface, 15.0));
  EXPECT_NEAR(featureCoverage(surface, features, 1e-3, 1e-9).missing, unmarked, 0.01 * unmarked);
}

TEST(FeatureRelease, OfGoodElementsIsNothing)
{
  const TargetFeatures features = featuresOf(creasedShapes()[1]);
  EditableSurface surface = captureOfWedge(features);
  EXPECT_TRUE(crampedFeatures(surface, 0.0).empty());
  EXPECT_EQ(featureCoverage(surface, features, 0.01, 1e-9).missing, 0.0);
}

TEST(FeatureRelease, OfEverythingLeavesNoCrease)
{
  const TargetFeatures features = featuresOf(creasedShapes()[1]);
  EditableSurface surface = captureOfWedge(features);
  const std::vector<Index> all = crampedFeatures(surface, 61.0);
  EXPECT_FALSE(all.empty());
  releaseFeatures(surface, all);
  const FeatureCoverage coverage = featureCoverage(surface, features, 0.01, 10.0);
  EXPECT_NEAR(coverage.missing, coverage.length, 1e-9);
  for (const Index v : editing::verticesOf(surface))
  {
    ASSERT_FALSE(surface.isPinned(v));
  }
  EXPECT_TRUE(crampedFeatures(surface, 61.0).empty());
}

TEST(FeatureRelease, LocksStay)
{
  const TargetFeatures features = featuresOf(creasedShapes()[1]);
  EditableSurface surface = captureOfWedge(features);
  const std::set<Index> free = wanted(surface, 15.0);
  surface.setLocked(*free.begin());
  releaseFeatures(surface, crampedFeatures(surface, 15.0));
  EXPECT_TRUE(surface.isLocked(*free.begin()));
}

} // namespace
