// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCapture/CaptureShapes.h"
#include "FeatureCapture/FeatureCoverage.h"
#include "FeatureCapture/FeatureReference.h"
#include "FeatureCapture/FeatureRelease.h"
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

/// Vertices on creases at triangles with a smaller angle.
std::vector<Index> crampedFeatures(
  const EditableSurface& surface, double angle, double atTips = 180.0)
{
  CreaseWorth worth;
  worth.angle = angle;
  worth.atTips = atTips;
  return creaseVertices(surface, crampedFaces(surface, worth));
}

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

/// Whose sides have an angle at the tip, vertex 0, in degrees; its edges there are creases, and it
/// is pinned.
EditableSurface creasedPyramid(Index sides, double angle)
{
  EditableSurface surface(shapes::pyramid(sides, sides * angle));
  surface.forEachOutgoing(0, [&](Index e) { surface.setCurve(e, 0); });
  surface.setPinned(0);
  return surface;
}

TEST(FeatureRelease, SparesTips)
{
  const EditableSurface sharp = creasedPyramid(4, 30.0);
  EXPECT_EQ(crampedFeatures(sharp, 33.0).size(), 5U);
  EXPECT_TRUE(crampedFeatures(sharp, 33.0, 22.0).empty());
  EXPECT_EQ(crampedFeatures(sharp, 33.0, 31.0).size(), 5U);
  EXPECT_TRUE(crampedFeatures(sharp, 29.0, 31.0).empty()); // never more than elsewhere
  EditableSurface free = sharp;
  free.releasePin(0);
  EXPECT_EQ(crampedFeatures(free, 33.0, 22.0).size(), 5U);
}

/// With one of its creases only, to vertex 2.
EditableSurface pyramidWithOneCrease(Index sides, double angle)
{
  EditableSurface surface = creasedPyramid(sides, angle);
  surface.forEachOutgoing(
    0, [&](Index e) { surface.setCurve(e, surface.to(e) == 2 ? 0 : NoIndex); });
  return surface;
}

TEST(FeatureRelease, SparesNoBluntCorner)
{
  const EditableSurface blunt = pyramidWithOneCrease(7, 26.0); // 182 degrees in all
  EXPECT_EQ(crampedFeatures(blunt, 33.0, 22.0), (std::vector<Index>{ 0, 2 }));
  const EditableSurface tip = pyramidWithOneCrease(6, 26.0);
  EXPECT_TRUE(crampedFeatures(tip, 33.0, 22.0).empty());
}

TEST(FeatureRelease, SparesTrianglesThatFillACorner)
{
  EditableSurface blunt = creasedPyramid(7, 26.0);
  EXPECT_TRUE(crampedFeatures(blunt, 33.0, 22.0).empty());
  EXPECT_EQ(crampedFeatures(blunt, 33.0, 27.0).size(), 8U);
  blunt.releasePin(0); // then it is no corner
  EXPECT_EQ(crampedFeatures(blunt, 33.0, 22.0).size(), 8U);
}

/// Each of the creases at the tip of a pyramid is a curve of its own, number k to vertex 2 + k.
EditableSurface pyramidOfCurves(Index sides, double angle)
{
  EditableSurface surface = creasedPyramid(sides, angle);
  surface.forEachOutgoing(0, [&](Index e) { surface.setCurve(e, surface.to(e) - 2); });
  for (Index f = 0; f < surface.faceSlots(); ++f)
  {
    surface.setLabel(f, f / 2);
  }
  return surface;
}

Index edgeTo(const EditableSurface& surface, Index v, Index w)
{
  Index found = NoIndex;
  surface.forEachOutgoing(v, [&](Index e) { found = surface.to(e) == w ? e : found; });
  return found;
}

TEST(FeatureRelease, LetsTheWeakerOfTwoGoFirst)
{
  EditableSurface surface = pyramidOfCurves(4, 30.0);
  CreaseWorth worth;
  worth.angle = 31.0;
  worth.folds = { 50.0, 40.0, 60.0, 70.0 };
  const Index between = EditableSurface::faceOf(edgeTo(surface, 0, 2)); // curves 0 and 1
  const Index before = EditableSurface::faceOf(edgeTo(surface, 0, 3));  // 1 and 2
  const Index after = EditableSurface::faceOf(edgeTo(surface, 0, 5));   // 3 and 0
  ASSERT_EQ(crampedFaces(surface, worth).size(), 4U);
  releaseWeakest(surface, { between }, worth);
  EXPECT_EQ(surface.curve(edgeTo(surface, 0, 3)), NoIndex);
  EXPECT_EQ(surface.curve(edgeTo(surface, 3, 0)), NoIndex);
  for (const Index k : { 0, 2, 3 })
  {
    EXPECT_EQ(surface.curve(edgeTo(surface, 0, 2 + k)), k);
  }
  EXPECT_TRUE(surface.isPinned(0));
  EXPECT_EQ(surface.label(between), FeatureReference::NoPatch);
  EXPECT_EQ(surface.label(before), FeatureReference::NoPatch);
  EXPECT_EQ(surface.label(after), after / 2);
}

TEST(FeatureRelease, KeepsTipsThatThreeTrianglesCanHave)
{
  for (const double atTips : { 41.0, 39.0 }) // 120 degrees around the tip
  {
    EditableSurface surface = creasedPyramid(4, 30.0);
    CreaseWorth worth;
    worth.atTips = atTips;
    releaseFeatures(surface, { 0 }, worth);
    EXPECT_EQ(surface.featureEdges(0), 0);
    EXPECT_EQ(surface.isPinned(0), atTips < 40.0);
    EditableSurface slowly = creasedPyramid(4, 30.0);
    slowly.forEachOutgoing(0, [&](Index e) { slowly.setCurve(e, NoIndex); });
    slowly.setCurve(edgeTo(slowly, 0, 2), 0);
    releaseWeakest(slowly, { EditableSurface::faceOf(edgeTo(slowly, 0, 2)) }, worth);
    EXPECT_EQ(slowly.featureEdges(0), 0);
    EXPECT_EQ(slowly.isPinned(0), atTips < 40.0);
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
