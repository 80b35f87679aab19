// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/SurfaceReport.h"

#include "ShrinkWrap/Shortcomings.h"
#include "ShrinkWrap/WrapRuns.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace evolving;
using evolving::wraps::fromSphere;

TEST(SurfaceReport, OfASphereInsideAnother)
{
  const SurfaceReport report = examine(icosphere(3, 0.9), fromSphere(1.0));
  EXPECT_TRUE(report.isClosed);
  EXPECT_TRUE(report.isManifold);
  EXPECT_EQ(report.selfIntersections, 0);
  EXPECT_EQ(report.genus, 0);
  EXPECT_GT(report.minAngle, 50.0);
  EXPECT_NEAR(report.maxDistance, 0.1, 0.002);
}

TEST(SurfaceReport, FindsAHoleAndAFlippedFace)
{
  SurfaceMesh open = icosphere(2);
  open.cornerVertices.resize(open.cornerVertices.size() - 3);
  open.faceOffsets.pop_back();
  const SurfaceReport ofOpen = examine(open, fromSphere(1.0));
  EXPECT_FALSE(ofOpen.isClosed);
  EXPECT_EQ(ofOpen.genus, -1);
  SurfaceMesh flipped = icosphere(2);
  std::swap(flipped.cornerVertices[0], flipped.cornerVertices[1]);
  EXPECT_FALSE(examine(flipped, fromSphere(1.0)).isManifold);
}

TEST(SurfaceReport, CountsIntersections)
{
  SurfaceMesh dented = icosphere(3);
  // A vertex pulled through the far side.
  dented.points[20] *= -1.2;
  EXPECT_GT(examine(dented, fromSphere(1.0)).selfIntersections, 0);
}

TEST(SurfaceReport, SaysWhatIsWrongAndWhere)
{
  EXPECT_TRUE(shortcomings(examine(icosphere(3), fromSphere(1.0)), 0.15).empty());
  SurfaceMesh spiked = icosphere(3);
  spiked.points[20] *= 3.0;
  const SurfaceReport report = examine(spiked, fromSphere(1.0));
  EXPECT_NEAR(report.maxDistance, 2.0, 1e-12);
  EXPECT_EQ(report.maxDistancePlace, spiked.points[20]);
  EXPECT_LT(report.minAngle, 20.0);
  const std::vector<std::string> sentences = shortcomings(report, 0.15);
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_NE(sentences[0].find("smallest angle"), std::string::npos);
  EXPECT_NE(sentences[1].find("membrane"), std::string::npos);
}

TEST(SurfaceReport, SaysWhereElementsCouldNotFollowTheCurvature)
{
  SurfaceReport report = examine(icosphere(3), fromSphere(1.0));
  report.adaptation.place = Vec3(1.5, 2.5, 3.5);
  EXPECT_TRUE(shortcomings(report, 0.15).empty());
  report.adaptation.isLeftOut = true;
  const std::vector<std::string> sentences = shortcomings(report, 0.15);
  ASSERT_EQ(sentences.size(), 1u);
  for (const char* words : { "uniform", "1.5 2.5 3.5", "AdaptToCurvature", "TargetEdgeLength" })
  {
    EXPECT_NE(sentences[0].find(words), std::string::npos) << words;
  }
}

TEST(SurfaceReport, AdvisesWhatIsSet)
{
  SurfaceReport report = examine(icosphere(3), fromSphere(1.0));
  report.minAngle = 5.0;
  EXPECT_NE(
    shortcomings(report, 0.15).front().find("a smaller TargetEdgeLength"), std::string::npos);
  report.morePoints = 1284;
  EXPECT_NE(
    shortcomings(report, 0.15).front().find("a TargetNumberOfPoints of 1284"), std::string::npos);
}

TEST(SurfaceReport, SaysThatASurfaceIsOpenOrRunsThroughItself)
{
  SurfaceMesh open = icosphere(2);
  open.cornerVertices.resize(open.cornerVertices.size() - 3);
  open.faceOffsets.pop_back();
  const std::vector<std::string> ofOpen = shortcomings(examine(open, fromSphere(1.0)), 0.3);
  ASSERT_EQ(ofOpen.size(), 1u);
  EXPECT_NE(ofOpen[0].find("not a closed manifold"), std::string::npos);
  // Two spheres that overlap.
  SurfaceMesh crossing = icosphere(3);
  const SurfaceMesh other = icosphere(3, 1.0, Vec3(1.7, 0.0, 0.0));
  for (Index f = 0; f < other.faceCount(); ++f)
  {
    const Index shift = icosphere(3).vertexCount();
    crossing.addFace({ shift + other.faceVertex(f, 0), shift + other.faceVertex(f, 1),
      shift + other.faceVertex(f, 2) });
  }
  crossing.points.insert(crossing.points.end(), other.points.begin(), other.points.end());
  const SurfaceReport report = examine(crossing, [](const Vec3&) { return 0.0; });
  EXPECT_NEAR(report.intersectionPlace.x(), 0.85, 0.15);
  const std::vector<std::string> ofCrossing = shortcomings(report, 0.15);
  ASSERT_EQ(ofCrossing.size(), 1u);
  const std::string count = std::to_string(report.selfIntersections) + " pairs";
  EXPECT_NE(ofCrossing[0].find(count), std::string::npos) << ofCrossing[0];
}

TEST(SurfaceReport, BoundsAreTwentyDegreesAndTwoEdges)
{
  SurfaceReport report;
  report.isClosed = true;
  report.isManifold = true;
  report.minAngle = 20.0;
  report.maxDistance = 0.4;
  EXPECT_TRUE(shortcomings(report, 0.2).empty());
  EXPECT_EQ(shortcomings(report, 0.19).size(), 1u);
  report.minAngle = 19.9;
  EXPECT_EQ(shortcomings(report, 0.2).size(), 1u);
  report.isManifold = false;
  report.selfIntersections = 1;
  report.maxDistance = 0.5;
  EXPECT_EQ(shortcomings(report, 0.2).size(), 4u);
}

TEST(SurfaceReport, SaysHowMuchOfTheTargetIsLost)
{
  // Of the samples on a line through a sphere those beyond 1 + far; the farthest is named.
  std::vector<Vec3> samples;
  for (int i = 0; i < 100; ++i)
  {
    samples.emplace_back(0.02 * (i + 0.5), 0.0, 0.0);
  }
  SurfaceReport report = examine(icosphere(4), fromSphere(1.0));
  measureLoss(icosphere(4), samples, 0.9, report);
  EXPECT_NEAR(report.lostPart, 0.1, 0.011); // 0 ... 0.1 and 1.9 ... 2
  EXPECT_EQ(report.lostPlace, samples.back());
  ASSERT_EQ(shortcomings(report, 0.45).size(), 1u);
  EXPECT_NE(shortcomings(report, 0.45)[0].find("10 %"), std::string::npos);
  report = examine(icosphere(4), fromSphere(1.0));
  measureLoss(icosphere(4), samples, 1.1, report);
  EXPECT_EQ(report.lostPart, 0.0);
  EXPECT_TRUE(shortcomings(report, 0.45).empty());
  measureLoss({}, samples, 1.1, report);
  EXPECT_EQ(report.lostPart, 1.0);
}

TEST(SurfaceReport, OfAnEmptySurfaceIsAllZero)
{
  const SurfaceReport report = examine({}, fromSphere(1.0));
  EXPECT_EQ(report.minAngle, 0.0);
  EXPECT_EQ(report.maxDistance, 0.0);
  EXPECT_EQ(report.selfIntersections, 0);
}

} // namespace
