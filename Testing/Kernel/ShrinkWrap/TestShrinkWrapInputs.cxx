// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// What becomes of inputs that are no clean closed surface.

#include "Checks/Refusal.h"
#include "Checks/SurfaceMeasures.h"
#include "Errors.h"
#include "Mesh/Angles.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/HoleyShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "Shapes/Tubes.h"
#include "ShrinkWrap/WrapRuns.h"
#include "ShrinkWrap/WrapTarget.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace evolving;

using namespace evolving::shapes;
using namespace evolving::wraps;

TEST(ShrinkWrapInputs, PolygonsAreRefused)
{
  const SurfaceMesh quad =
    shapes::makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, { { 0, 1, 2, 3 } });
  EXPECT_THROW(prepareShrinkWrap(quad, quick()), InputError);
}

TEST(ShrinkWrapInputs, OrientationDoesNotMatter)
{
  const SurfaceMesh torus = shapes::torus(48, 24, 1.0, 0.4);
  const SurfaceMesh result = wrap(torus, quick(0.12));
  std::mt19937 generator(3);
  SurfaceMesh mixed = torus;
  for (std::size_t f = 0; f < mixed.cornerVertices.size(); f += 3)
  {
    if (generator() % 2 == 0)
    {
      std::swap(mixed.cornerVertices[f], mixed.cornerVertices[f + 1]);
    }
  }
  for (const SurfaceMesh& input : { reversed(torus), mixed, soupOf(torus) })
  {
    const SurfaceMesh other = wrap(input, quick(0.12));
    expectSound(other, 1);
    EXPECT_LT(checks::hausdorff(other, torus, 0.05), 0.01);
    EXPECT_NEAR(signedVolume(other), signedVolume(result), 0.002 * signedVolume(result));
  }
}

TEST(ShrinkWrapInputs, OverlappingPartsBecomeTheirUnion)
{
  // Two unit balls one apart: of both a lens of 5 pi / 12 is shared.
  const SurfaceMesh ball = icosphere(4);
  const SurfaceMesh other = shapes::transformed(ball, 1.0, Vec3::UnitX());
  const SurfaceMesh result = wrap(shapes::merged(ball, reversed(other)), quick(0.1, 64));
  expectSound(result, 0);
  EXPECT_NEAR(signedVolume(result), (8.0 / 3.0 - 5.0 / 12.0) * Pi, 0.08);
}

TEST(ShrinkWrapInputs, InnerGeometryLeavesNoTrace)
{
  const SurfaceMesh ball = icosphere(4);
  SurfaceMesh filled = shapes::merged(ball, shapes::transformed(ball, 0.5, Vec3(0.2, 0.1, 0.0)));
  filled =
    shapes::merged(filled, shapes::transformed(shapes::sheet(4, true), 0.8, Vec3(-0.4, -0.4, 0.3)));
  const SurfaceMesh result = wrap(filled);
  expectSound(result, 0);
  EXPECT_LT(checks::hausdorff(result, ball, 0.05), 0.01);
}

TEST(ShrinkWrapInputs, GapSizeDecidesWhatIsEntered)
{
  // A bowl whose mouth is 2 sin(0.5) = 0.96 wide.
  const SurfaceMesh bowl = shapes::drilledSphere({ Vec3::UnitZ() }, 0.5);
  ShrinkWrapOptions options = quick(0.1, 64);
  const SurfaceMesh entered = wrap(bowl, options);
  expectSound(entered, 0);
  EXPECT_NEAR(surfaceArea(entered), 2.0 * surfaceArea(bowl), 0.15 * surfaceArea(bowl));
  EXPECT_LT(signedVolume(entered), 1.2);
  options.gapSize = 1.2;
  const SurfaceMesh closed = wrap(bowl, options);
  expectSound(closed, 0);
  EXPECT_GT(signedVolume(closed), 0.95 * 4.0 / 3.0 * Pi);
}

TEST(ShrinkWrapInputs, AnOpenSheetBecomesAThinWall)
{
  const auto height = [](const Vec3& p)
  { return 0.2 * std::sin(3.0 * p.x()) * std::cos(2.0 * p.y()); };
  SurfaceMesh sheet = shapes::transformed(shapes::sheet(24, true), 2.0, Vec3(-1.0, -1.0, 0.0));
  for (Vec3& p : sheet.points)
  {
    p.z() = height(p);
  }
  const double edge = 0.1;
  const double wall = TargetTuning().wallPerEdge * edge;
  const SurfaceMesh result = wrap(sheet, quick(edge, 64));
  expectSound(result, 0);
  // The rim, 8 long, draws back by less than an element; there elements are larger than the wall is
  // thick.
  EXPECT_NEAR(surfaceArea(result), 2.0 * surfaceArea(sheet), 2.0 * 8.0 * edge);
  EXPECT_NEAR(
    signedVolume(result), 2.0 * wall * surfaceArea(sheet), 0.4 * wall * surfaceArea(sheet));
  EXPECT_LT(checks::farthest(result, sheet, 0.05), 2.5 * wall);
  EXPECT_LT(checks::farthest(sheet, result, 0.05), 3.0 * edge); // at its corners
  const AABBTree tree(sheet);
  double largest = 0.0;
  for (const Vec3& p : result.points)
  {
    const double distance = std::sqrt(tree.closest(p).at.squaredDistance);
    const bool isInner = p.cwiseAbs().head<2>().maxCoeff() < 1.0 - 3.0 * edge;
    largest = isInner ? std::max(largest, std::abs(distance - wall)) : largest;
  }
  EXPECT_LT(largest, 0.2 * wall);
}

TEST(ShrinkWrapInputs, OneTriangleBecomesAThinWall)
{
  const SurfaceMesh triangle =
    shapes::triangleMesh(Vec3::Zero(), Vec3(2.0, 0.3, 0.1), Vec3(0.4, 1.8, 0.9));
  const SurfaceMesh result = wrap(triangle, quick(0.1, 64));
  expectSound(result, 0);
  EXPECT_LT(checks::farthest(result, triangle, 0.05), 2.5 * 0.03);
  EXPECT_NEAR(surfaceArea(result), 2.0 * surfaceArea(triangle), 0.5 * surfaceArea(triangle));
}

TEST(ShrinkWrapInputs, DegenerateTrianglesAndUnusedPointsAreLeftOut)
{
  const SurfaceMesh ball = icosphere(3);
  SurfaceMesh dirty = ball;
  dirty.addFace({ 0, 0, 1 });
  dirty.addFace({ 5, 5, 5 });
  dirty.addPoint(Vec3(100.0, 0.0, 0.0));
  EXPECT_TRUE(wrap(dirty, quick(0.2, 32)) == wrap(ball, quick(0.2, 32)));
}

TEST(ShrinkWrapInputs, FacesGivenTwiceChangeNothingMuch)
{
  const SurfaceMesh ball = icosphere(3);
  const SurfaceMesh result = wrap(shapes::merged(ball, reversed(ball)), quick(0.2, 32));
  expectSound(result, 0);
  EXPECT_LT(checks::hausdorff(result, ball, 0.05), 0.02);
}

std::string refusal(const SurfaceMesh& input, const ShrinkWrapOptions& options = {})
{
  return checks::refusalOf([&] { prepareShrinkWrap(input, options); });
}

TEST(ShrinkWrapInputs, WhatCannotBeWrappedIsRefusedInOneSentence)
{
  const Vec3 nowhere(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  const Vec3 far(0.0, std::numeric_limits<double>::infinity(), 0.0);
  const Vec3 one = Vec3::Ones();
  SurfaceMesh equalPoints;
  equalPoints.points = { one, one, one };
  SurfaceMesh lostPoints = equalPoints;
  lostPoints.points = { one, nowhere, far };
  SurfaceMesh wrongNumber = shapes::triangleMesh(one, Vec3::Zero(), Vec3::UnitX());
  wrongNumber.cornerVertices[1] = 3;
  const std::vector<std::pair<SurfaceMesh, std::string>> cases = {
    { {}, "single point or empty" },
    { equalPoints, "single point or empty" },
    { shapes::triangleMesh(one, one, one), "single point or empty" },
    { shapes::triangleMesh(one, Vec3::Zero(), -one), "no area" },
    { shapes::triangleMesh(one, nowhere, Vec3::Zero()), "finite" },
    { shapes::triangleMesh(one, far, Vec3::Zero()), "finite" },
    { lostPoints, "finite" },
    { wrongNumber, "" },
  };
  for (const auto& [input, words] : cases)
  {
    const std::string sentence = refusal(input);
    ASSERT_FALSE(sentence.empty()) << words;
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
    EXPECT_EQ(sentence.back(), '.');
  }
}

TEST(ShrinkWrapInputs, FacesWithoutAreaHaveNoSidesWhateverTheEdgeLength)
{
  ShrinkWrapOptions options;
  options.sampleDimensions = { 32, 32, 32 };
  options.targetEdgeLength = 0.05;
  const Vec3 far(100.3, -99.7, 101.1);
  const Vec3 along(0.3, 0.5, 0.7);
  const SurfaceMesh line = shapes::triangleMesh(far, far + along, far + 0.3 * along);
  EXPECT_NE(refusal(line, options).find("no area"), std::string::npos);
}

TEST(ShrinkWrapInputs, TooManyElementsAreRefusedBeforeAnyIsMade)
{
  ShrinkWrapOptions options;
  options.sampleDimensions = { 32, 32, 32 };
  options.targetEdgeLength = 0.05;
  options.offsetDistance = 20.0;
  const SurfaceMesh sphere = icosphere(3);
  EXPECT_NE(refusal(sphere, options).find("set TargetEdgeLength"), std::string::npos);
  options.offsetDistance = 0.0;
  options.targetEdgeLength = 1e-6;
  EXPECT_NE(refusal(sphere, options).find("set TargetEdgeLength"), std::string::npos);
}

TEST(ShrinkWrapInputs, OfAHairElementsAreNotAsSmallAsItsAreaAsksFor)
{
  ShrinkWrapOptions options;
  options.sampleDimensions = { 16, 16, 16 };
  const SurfaceMesh hair = shapes::triangleMesh(Vec3::Zero(), Vec3::UnitX(), Vec3(0.5, 1e-9, 0.0));
  EXPECT_NEAR(wraps::describe(hair, options, {}).target.edgeLength, 2.5e-3, 1e-12);
}

TEST(ShrinkWrapInputs, PointsTooFarApartForAGapSizeGetAWallAroundThem)
{
  SurfaceMesh points;
  for (int i = 0; i < 6; ++i)
  {
    for (int j = 0; j < 6; ++j)
    {
      points.addPoint(Vec3(i, j, std::sin(i + j)));
    }
  }
  ShrinkWrapOptions options = quick(0.4);
  options.gapSize = 0.01;
  const SurfaceMesh result = wrap(points, options);
  expectSound(result, 0);
  EXPECT_GT(boundingBox(result).sizes().x(), 5.0);
  EXPECT_GT(boundingBox(result).sizes().y(), 5.0);
}

} // namespace
