// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/SheetOpenness.h"

#include "ShrinkWrap/SheetShapes.h"
#include "ShrinkWrap/TrianglePlaces.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace evolving;
using namespace evolving::wraps;

namespace
{

/// At the centroids of all triangles.
std::vector<double> openness(const ReachedTarget& target)
{
  const SheetOpenness sides(target.tree, target.region);
  std::vector<double> values;
  for (Index t = 0; t < target.tree.triangleCount(); ++t)
  {
    const auto& [a, b, c] = target.tree.triangle(t).corners;
    values.push_back(sides.at(t, (a + b + c) / 3.0));
  }
  return values;
}

} // namespace

TEST(SheetOpenness, OfATriangleIsThatOfAllItsPlaces)
{
  const ReachedTarget target(shapes::merged(coveredPlate(3), plate(3, -0.7)));
  const SheetOpenness sides(target.tree, target.region);
  int counts[3] = {};
  for (Index t = 0; t < target.tree.triangleCount(); ++t)
  {
    const auto places = placesOf(target.tree.triangle(t));
    const bool isSmall = target.tree.triangle(t).box().diagonal().norm() < target.region.radius();
    const auto open = std::count_if(isSmall ? places.end() - 1 : places.begin(), places.end(),
      [&](const Vec3& p) { return sides.at(t, p) > 0.5; });
    const SidesOpen expected = open == 0
      ? SidesOpen::One
      : (open == (isSmall ? 1 : 7) ? SidesOpen::Both : SidesOpen::Varying);
    EXPECT_EQ(sides.sidesOf(t), expected) << t;
    ++counts[static_cast<int>(expected)];
  }
  EXPECT_GT(*std::min_element(counts, counts + 3), 0) << counts[0] << counts[1] << counts[2];
}

TEST(SheetOpenness, OfASheetAloneIsOneEverywhere)
{
  const ReachedTarget target(plate(8));
  const SheetOpenness sides(target.tree, target.region);
  for (Index t = 0; t < target.tree.triangleCount(); ++t)
  {
    EXPECT_EQ(sides.sidesOf(t), SidesOpen::Both) << t;
    for (const Vec3& p : target.tree.triangle(t).corners)
    {
      EXPECT_EQ(sides.at(t, p), 1.0) << p.transpose();
    }
  }
}

TEST(SheetOpenness, OfAClosedSurfaceIsNoneHoweverItIsTurned)
{
  for (const SurfaceMesh& ball : { icosphere(3), reversed(icosphere(3)) })
  {
    const ReachedTarget target(ball);
    const SheetOpenness sides(target.tree, target.region);
    for (const double value : openness(target))
    {
      EXPECT_EQ(value, 0.0);
    }
    for (Index t = 0; t < target.tree.triangleCount(); ++t)
    {
      EXPECT_EQ(sides.sidesOf(t), SidesOpen::One) << t;
    }
  }
}

TEST(SheetOpenness, NeedsRoomForTheBallBetweenTwoSheets)
{
  // The ball's diameter is 0.4: it rolls between sheets that are 1 apart, not between 0.2.
  for (const double value : openness(ReachedTarget(shapes::merged(plate(6, -0.5), plate(6, 0.5)))))
  {
    EXPECT_EQ(value, 1.0);
  }
  for (const double value : openness(ReachedTarget(shapes::merged(plate(6, -0.1), plate(6, 0.1)))))
  {
    EXPECT_EQ(value, 0.0);
  }
}

TEST(SheetOpenness, VariesWhereOnlyAPartIsCovered)
{
  // Two triangles over the whole plate: the left half is open, the right half is not.
  const ReachedTarget target(coveredPlate(1));
  const SheetOpenness sides(target.tree, target.region);
  for (const Index t : { 0, 1 })
  {
    EXPECT_EQ(sides.sidesOf(t), SidesOpen::Varying);
  }
  for (Index t = 2; t < target.tree.triangleCount(); ++t)
  {
    EXPECT_EQ(sides.sidesOf(t), SidesOpen::One) << "of the box";
  }
  // Triangle 0 is below the diagonal: y < x.
  double last = 1.0;
  for (const double x : { -0.8, -0.6, -0.4, 0.3, 0.6, 0.9 })
  {
    const double value = sides.at(0, Vec3(x, -0.95, 0.0));
    EXPECT_EQ(value, x < 0.0 ? 1.0 : 0.0) << x;
    EXPECT_LE(value, last);
    last = value;
  }
}

TEST(SheetOpenness, OfSmallTrianglesIsThatOfTheLargeOnesTheyDivide)
{
  // Triangles no larger than the ball are asked at one place: all but those at the cover's edge
  // must agree with their whole.
  const ReachedTarget target(coveredPlate(24));
  const SheetOpenness sides(target.tree, target.region);
  for (Index t = 0; t < 2 * 24 * 24; ++t)
  {
    const auto& [a, b, c] = target.tree.triangle(t).corners;
    const double x = (a.x() + b.x() + c.x()) / 3.0;
    if (std::abs(x) > 0.35)
    {
      EXPECT_EQ(sides.sidesOf(t), x < 0.0 ? SidesOpen::Both : SidesOpen::One) << x;
    }
  }
}

TEST(SheetOpenness, IsBetweenZeroAndOneAndTheSameFromBehind)
{
  const SurfaceMesh mesh = coveredPlate(5);
  const ReachedTarget target(mesh);
  const ReachedTarget behind(reversed(mesh));
  const std::vector<double> values = openness(target);
  const std::vector<double> others = openness(behind);
  ASSERT_EQ(values.size(), others.size());
  for (std::size_t t = 0; t < values.size(); ++t)
  {
    EXPECT_GE(values[t], 0.0);
    EXPECT_LE(values[t], 1.0);
    EXPECT_NEAR(values[t], others[t], 1e-12) << t;
  }
}

TEST(SheetOpenness, DoesNotDependOnTheUnit)
{
  const std::vector<double> expected = openness(ReachedTarget(coveredPlate(5)));
  for (const double scale : { 0x1p-12, 0x1p12 })
  {
    EXPECT_EQ(openness(ReachedTarget(coveredPlate(5), scale)), expected) << scale;
  }
}
