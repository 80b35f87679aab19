// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/ShrinkWrap.h"

#include "Checks/SurfaceMeasures.h"
#include "Errors.h"
#include "Evolution/SurfaceFlow.h"
#include "Mesh/MeshQuality.h"
#include "Mesh/TopologySummary.h"
#include "Shapes/MeshVariants.h"
#include "ShrinkWrap/SurfaceReport.h"
#include "ShrinkWrap/WrapRuns.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{

using namespace evolving;
using namespace evolving::wraps;

ShrinkWrapOptions coarse()
{
  ShrinkWrapOptions options;
  options.sampleDimensions = { 40, 40, 40 };
  options.targetEdgeLength = 0.15;
  options.numberOfSteps = 20;
  return options;
}

TEST(ShrinkWrap, WrapsASphere)
{
  const SurfaceMesh sphere = icosphere(4);
  const SurfaceMesh result = wrap(sphere, coarse());
  const SurfaceReport report = examine(result, fromSphere(1.0));
  EXPECT_TRUE(report.isClosed);
  EXPECT_TRUE(report.isManifold);
  EXPECT_EQ(report.genus, 0);
  EXPECT_EQ(report.selfIntersections, 0);
  EXPECT_GT(report.minAngle, 44.0);
  EXPECT_LT(report.maxDistance, 0.01);
  EXPECT_GT(signedVolume(result), 0.0);
}

TEST(ShrinkWrap, EdgesHaveTheLengthAskedFor)
{
  const SurfaceMesh result = wrap(icosphere(4), coarse());
  EXPECT_NEAR(meanEdgeLength(result), coarse().targetEdgeLength, 0.1 * coarse().targetEdgeLength);
}

TEST(ShrinkWrap, DefaultEdgeLengthGivesNineThousandVertices)
{
  ShrinkWrapOptions options = coarse();
  options.targetEdgeLength = 0.0;
  const ShrinkWrapProblem problem = prepareShrinkWrap(icosphere(4), options);
  EXPECT_NEAR(problem.start->vertexCount(), 9000, 1500);
  // Equilateral triangles of edge 1 have two triangles, so one vertex, per sqrt(3) / 2 of area.
  EXPECT_NEAR(defaultEdgeLength(9000.0 * std::sqrt(3.0) / 2.0, 60.0), 1.0, 1e-12);
  EXPECT_EQ(defaultEdgeLength(1e-20, 500.0), 1.25); // a needle
  EXPECT_EQ(edgeLengthFor(900.0, 1e-20, 500.0), 12.5);
}

TEST(ShrinkWrap, OffsetDistanceIsKept)
{
  ShrinkWrapOptions options = coarse();
  options.offsetDistance = 0.2;
  const SurfaceMesh sphere = icosphere(4);
  const SurfaceMesh result = wrap(sphere, options);
  EXPECT_NEAR(checks::meanRadius(result), 1.2, 0.005);
  EXPECT_LT(examine(result, fromSphere(1.2)).maxDistance, 0.01);
}

TEST(ShrinkWrap, GapSizeClosesANotch)
{
  // Two boxes 0.3 apart: one surface each, and one surface when gaps below 0.5 close.
  const SurfaceMesh left = subdividedBox(4, Vec3::Constant(0.5), Vec3(-0.65, 0.0, 0.0));
  SurfaceMesh both = left;
  const SurfaceMesh right = subdividedBox(4, Vec3::Constant(0.5), Vec3(0.65, 0.0, 0.0));
  for (Index face = 0; face < right.faceCount(); ++face)
  {
    std::vector<Index> corners;
    for (Index k = 0; k < right.faceSize(face); ++k)
    {
      corners.push_back(left.vertexCount() + right.faceVertex(face, k));
    }
    both.addFace(corners);
  }
  both.points.insert(both.points.end(), right.points.begin(), right.points.end());
  SurfaceMesh triangles;
  triangles.points = both.points;
  for (Index face = 0; face < both.faceCount(); ++face)
  {
    triangles.addFace(
      { both.faceVertex(face, 0), both.faceVertex(face, 1), both.faceVertex(face, 2) });
    triangles.addFace(
      { both.faceVertex(face, 0), both.faceVertex(face, 2), both.faceVertex(face, 3) });
  }
  ShrinkWrapOptions options = coarse();
  options.targetEdgeLength = 0.08;
  EXPECT_EQ(summarizeTopology(*prepareShrinkWrap(triangles, options).start).components, 2);
  options.gapSize = 0.5;
  EXPECT_EQ(summarizeTopology(*prepareShrinkWrap(triangles, options).start).components, 1);
}

TEST(ShrinkWrap, DoesNotDependOnUnitsAndPlace)
{
  const SurfaceMesh sphere = icosphere(3);
  const SurfaceMesh result = wrap(sphere, coarse());
  ShrinkWrapOptions scaled = coarse();
  scaled.targetEdgeLength *= 1e4;
  const Vec3 shift(3e5, -2e5, 1e5);
  const SurfaceMesh other = wrap(shapes::transformed(sphere, 1e4, shift), scaled);
  // Rounding decides which of two equal edges goes first, so the elements differ; not their number
  // and what they are worth.
  EXPECT_NEAR(other.vertexCount(), result.vertexCount(), 0.05 * result.vertexCount());
  const SurfaceReport report = examine(shapes::transformed(other, 1.0, -shift),
    [](const Vec3& p) { return std::abs(p.norm() - 1e4); });
  EXPECT_EQ(report.selfIntersections, 0);
  EXPECT_GT(report.minAngle, 44.0);
  EXPECT_LT(report.maxDistance, 0.015 * 1e4);
}

TEST(ShrinkWrap, ASphereStartEnclosesTheTarget)
{
  ShrinkWrapOptions options = coarse();
  options.start = WrapStart::Icosphere;
  const SurfaceMesh target = icosphere(3, 0.8);
  const SurfaceMesh result = wrap(target, options);
  EXPECT_LT(examine(result, fromSphere(0.8)).maxDistance, 0.02);
}

TEST(ShrinkWrap, WrapsPoints)
{
  SurfaceMesh points;
  points.points = icosphere(5).points;
  const SurfaceMesh result = wrap(points, coarse());
  const SurfaceReport report = examine(result, fromSphere(1.0));
  EXPECT_TRUE(report.isClosed);
  EXPECT_EQ(report.genus, 0);
  EXPECT_NEAR(checks::meanRadius(result), 1.0, 0.01);
}

TEST(ShrinkWrap, RefusesWhatCannotBeWrapped)
{
  EXPECT_THROW(prepareShrinkWrap({}, coarse()), InputError);
  SurfaceMesh point;
  point.addPoint(Vec3::Ones());
  EXPECT_THROW(prepareShrinkWrap(point, coarse()), InputError);
  SurfaceMesh broken = icosphere(1);
  broken.points[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(prepareShrinkWrap(broken, coarse()), InputError);
  ShrinkWrapOptions options = coarse();
  options.gapSize = -1.0;
  EXPECT_THROW(prepareShrinkWrap(icosphere(1), options), InputError);
}

TEST(ShrinkWrap, OptionsCompareByValue)
{
  ShrinkWrapOptions changed = coarse();
  EXPECT_TRUE(changed == coarse());
  changed.offsetDistance = 1.0;
  EXPECT_FALSE(changed == coarse());
}

TEST(ShrinkWrap, ProgressNeverGoesBack)
{
  SurfaceMesh points;
  points.points = icosphere(3).points;
  ShrinkWrapOptions fromSphere = coarse();
  fromSphere.start = WrapStart::Icosphere;
  for (const auto& options : { coarse(), fromSphere })
  {
    std::vector<double> fractions;
    const Execution execution(
      nullptr, [&](double fraction) { fractions.push_back(fraction); }, nullptr);
    const ShrinkWrapProblem problem = prepareShrinkWrap(points, options, execution.phase(0.0, 0.3));
    SurfaceFlow flow(
      problem.start, problem.field, problem.remesher, problem.flow, execution.phase(0.3, 1.0));
    while (!flow.isFinished())
    {
      flow.step();
    }
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_GT(fractions.size(), 100U);
    EXPECT_LE(fractions.back(), 1.0);
  }
}

} // namespace
