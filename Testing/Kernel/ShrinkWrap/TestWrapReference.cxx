// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Shapes/Draws.h"
#include "ShrinkWrap/WrapReference.h"

#include "Remeshing/RemeshingShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "ShrinkWrap/WrapRuns.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>

namespace
{

using namespace evolving;

std::shared_ptr<const WrapReference> referenceFor(
  const SurfaceMesh& mesh, const ShrinkWrapOptions& options = wraps::quick())
{
  return prepareShrinkWrap(mesh, options).reference;
}

SurfaceMesh sheetOfSide(double side, Index squares)
{
  const Vec3 middle(-0.5 * side, -0.5 * side, 0.0);
  return shapes::transformed(shapes::sheet(squares, true), side, middle);
}

Vec3 randomDirection(std::mt19937& generator)
{
  std::normal_distribution<double> normal;
  return shapes::drawnVector(normal, generator).normalized();
}

TEST(WrapReference, OfAClosedSurfaceIsTheSurface)
{
  for (const SurfaceMesh& sphere : { icosphere(4), reversed(icosphere(4)) })
  {
    const auto reference = referenceFor(sphere);
    EXPECT_FALSE(reference->hasSheets());
    EXPECT_TRUE(reference->isOnTarget());
    EXPECT_EQ(reference->visible().faceCount(), sphere.faceCount());
    std::mt19937 generator(1);
    for (int i = 0; i < 100; ++i)
    {
      const Vec3 way = randomDirection(generator);
      const auto foot = reference->onSurface(1.1 * way, way, 0, NoIndex);
      EXPECT_NEAR(foot.point.norm(), 1.0, 0.003);
      EXPECT_GT(foot.normal.dot(way), 0.99); // outwards, however the target is oriented
      EXPECT_NEAR(reference->deviation(1.1 * way), 0.1, 0.003);
      EXPECT_NEAR(reference->deviation(foot.point), 0.0, 1e-12);
    }
  }
}

TEST(WrapReference, HasNoPlaceForPointsFarAway)
{
  // Membranes stay: two edges of 0.15 are too far, a little less is not.
  const auto reference = referenceFor(icosphere(4));
  const Vec3 far(0.0, 0.0, 1.31);
  EXPECT_EQ(reference->onSurface(far, Vec3::UnitZ(), 0, NoIndex).point, far);
  const Vec3 near(0.0, 0.0, 1.28);
  EXPECT_NEAR(reference->onSurface(near, Vec3::UnitZ(), 0, NoIndex).point.z(), 1.0, 0.003);
}

TEST(WrapReference, HiddenPartsAreNoneOfIt)
{
  const SurfaceMesh outer = icosphere(4);
  const SurfaceMesh within = shapes::transformed(icosphere(3), 0.5, Vec3(0.1, 0.0, 0.0));
  const auto reference = referenceFor(shapes::merged(within, outer));
  EXPECT_EQ(reference->visible().faceCount(), outer.faceCount());
  EXPECT_TRUE(reference->isOnTarget());
  for (Index f = 0; f < outer.faceCount(); ++f)
  {
    ASSERT_GT(reference->visible().facePoint(f, 0).norm(), 0.99);
  }
  // Of the inner one's place it knows nothing.
  EXPECT_NEAR(reference->deviation(Vec3(0.6, 0.0, 0.0)), 0.4, 0.01);
}

TEST(WrapReference, ADoubleSidedSheetIsAWall)
{
  ShrinkWrapOptions options = wraps::quick();
  options.preserveFeatures = FeaturePreservation::Off; // else it is a solid
  const auto reference = referenceFor(sheetOfSide(2.0, 12), options);
  const double wall = TargetTuning().wallPerEdge * 0.15;
  EXPECT_TRUE(reference->hasSheets());
  EXPECT_FALSE(reference->isOnTarget());
  for (const double side : { 1.0, -1.0 })
  {
    const Vec3 point(0.3, -0.4, 0.1 * side);
    const Vec3 wanted(0.3, -0.4, wall * side);
    EXPECT_LT(
      (reference->onSurface(point, Vec3::UnitZ(), 0, NoIndex).point - wanted).norm(), 1e-12);
    // On the sheet itself the normal of the surface tells the side.
    const Vec3 on(0.3, -0.4, 0.0);
    const Vec3 facing(0.0, 0.0, side);
    EXPECT_LT((reference->onSurface(on, facing, 0, NoIndex).point - wanted).norm(), 1e-12);
    EXPECT_NEAR(reference->deviation(point), 0.1 - wall, 1e-12);
    EXPECT_NEAR(reference->deviation(on), wall, 1e-12);
  }
  // Around the rim it is round.
  const auto foot = reference->onSurface(Vec3(1.03, 0.0, 0.03), Vec3::UnitX(), 0, NoIndex);
  EXPECT_NEAR((foot.point - Vec3(1.0, 0.0, 0.0)).norm(), wall, 1e-12);
}

TEST(WrapReference, BesideTwoSheetsThatMeetItKeepsAwayFromBoth)
{
  // Two sheets at a right angle along the y axis: the closest point of either is too near the
  // other.
  SurfaceMesh upright = sheetOfSide(2.0, 12);
  for (Vec3& p : upright.points)
  {
    p = Vec3(0.0, p.y(), p.x());
  }
  const auto reference = referenceFor(shapes::merged(sheetOfSide(2.0, 12), upright));
  const double wall = TargetTuning().wallPerEdge * 0.15;
  for (const Vec3& point : { Vec3(0.02, 0.1, 0.03), Vec3(0.06, 0.1, 0.01), Vec3(0.01, 0.1, 0.02) })
  {
    const Vec3 foot =
      reference->onSurface(point, Vec3(1.0, 0.0, 1.0).normalized(), 0, NoIndex).point;
    EXPECT_GT(foot.x(), 0.97 * wall);
    EXPECT_GT(foot.z(), 0.97 * wall);
    EXPECT_LT(foot.x() + foot.z(), 3.0 * wall);
  }
}

TEST(WrapReference, AThinSolidPlateIsNoSheet)
{
  // Thinner than a wall would be, than a cell and than the ball.
  const auto reference = referenceFor(shapes::triangleBox(12, Vec3(1.0, 1.0, 0.01)));
  EXPECT_FALSE(reference->hasSheets());
  EXPECT_TRUE(reference->isOnTarget());
}

TEST(WrapReference, AFinOnASolidIsAWallAndTheSolidIsNot)
{
  // A sheet of 1 x 2 that stands on a box from its middle, and begins inside.
  SurfaceMesh fin = shapes::transformed(shapes::sheet(16, true), 1.0, Vec3(-0.5, 0.0, 0.0));
  for (Vec3& p : fin.points)
  {
    p = Vec3(p.x(), 0.01, 2.0 * p.y());
  }
  const SurfaceMesh both = shapes::merged(shapes::triangleBox(8, Vec3::Ones()), fin);
  const auto reference = referenceFor(both, wraps::quick(0.1));
  EXPECT_TRUE(reference->hasSheets());
  EXPECT_FALSE(reference->isOnTarget());
  const auto side = reference->onSurface(Vec3(0.2, 1.05, 0.3), Vec3::UnitY(), 0, NoIndex);
  const double moved = 1e-6 * boundingBox(both).diagonal().norm(); // at most, of parts that meet
  EXPECT_LT((side.point - Vec3(0.2, 1.0, 0.3)).norm(), moved);
  const auto wall = reference->onSurface(Vec3(0.1, 0.07, 1.7), Vec3::UnitY(), 0, NoIndex);
  EXPECT_LT((wall.point - Vec3(0.1, 0.01 + TargetTuning().wallPerEdge * 0.1, 1.7)).norm(), 1e-12);
}

TEST(WrapReference, AnOffsetIsADistanceFromTheSurface)
{
  ShrinkWrapOptions options = wraps::quick();
  options.offsetDistance = 0.2;
  const auto reference = referenceFor(shapes::triangleBox(4, Vec3::Ones()), options);
  EXPECT_FALSE(reference->isOnTarget());
  const Vec3 beyondEdge(1.3, 1.1, 0.2);
  const Vec3 edge(1.0, 1.0, 0.2);
  const auto foot = reference->onSurface(beyondEdge, Vec3::UnitX(), 0, NoIndex);
  EXPECT_LT((foot.point - (edge + 0.2 * (beyondEdge - edge).normalized())).norm(), 1e-12);
  EXPECT_NEAR(reference->deviation(Vec3(0.3, 0.2, 1.25)), 0.05, 1e-12);
}

TEST(WrapReference, GuessesOfOtherReferencesAreNone)
{
  const auto reference = referenceFor(sheetOfSide(2.0, 6));
  const Vec3 point(0.31, -0.42, 0.1);
  const auto expected = reference->onSurface(point, Vec3::UnitZ(), 0, NoIndex);
  for (const Index guess : { 72, 1000000, std::numeric_limits<Index>::max(), -5 })
  {
    EXPECT_EQ(reference->onSurface(point, Vec3::UnitZ(), 0, guess).point, expected.point);
  }
}

} // namespace
