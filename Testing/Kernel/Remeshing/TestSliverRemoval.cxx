// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/SliverRemoval.h"

#include "Errors.h"
#include "Mesh/MeshQuality.h"
#include "Mesh/SelfIntersections.h"
#include "Remeshing/EditingChecks.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Sheets.h"
#include "Shapes/Slivers.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;

namespace
{

double farthestFrom(const SurfaceMesh& target, const std::vector<Vec3>& points)
{
  const AABBTree tree(target);
  double farthest = 0.0;
  for (const Vec3& p : points)
  {
    farthest = std::max(farthest, std::sqrt(tree.closest(p).at.squaredDistance));
  }
  return farthest;
}

/// A box of twelve triangles.
SurfaceMesh plate(double thickness)
{
  SurfaceMesh mesh =
    shapes::mapped(subdividedBox(1), Vec3(1.0, 1.0, thickness).asDiagonal().toDenseMatrix());
  std::mt19937 generator(1);
  return mesh.hasOnlyTriangles() ? mesh : shapes::triangulated(mesh, generator);
}

} // namespace

TEST(SliverRemoval, TakesNeedlesOutOfClosedSurfaces)
{
  for (const double part : { 1e-12, 1e-6, 0.01, 0.05 })
  {
    for (const SurfaceMesh& good : { icosphere(3), shapes::torus(40, 20, 2.0, 0.7) })
    {
      const SurfaceMesh spoilt = shapes::withNeedles(good, 7, part);
      ASSERT_LT(smallestAngle(spoilt), 11.0);
      const auto result = withoutSlivers(spoilt);
      ASSERT_TRUE(result.has_value());
      EXPECT_GT(smallestAngle(*result), 20.0) << part;
      EXPECT_EQ(editing::kindOf(*result), editing::kindOf(spoilt));
      EXPECT_EQ(result->vertexCount(), good.vertexCount()); // the points put in, and no others
      EXPECT_TRUE(selfIntersections(*result).empty());
      EXPECT_LT(farthestFrom(good, result->points), 0.05 * meanEdgeLength(good));
    }
  }
}

TEST(SliverRemoval, TakesCapsOut)
{
  SurfaceMesh spoilt = icosphere(3);
  for (const Index face : { 100, 500, 900 })
  {
    spoilt = shapes::withCap(spoilt, face, 1e-4);
  }
  ASSERT_LT(smallestAngle(spoilt), 0.02);
  const auto result = withoutSlivers(spoilt);
  ASSERT_TRUE(result.has_value());
  EXPECT_GT(smallestAngle(*result), 20.0);
}

TEST(SliverRemoval, LeavesGoodElementsAlone)
{
  EXPECT_FALSE(withoutSlivers(icosphere(3)).has_value());
  EXPECT_FALSE(withoutSlivers(shapes::sheet(8, true)).has_value());
  // Fine elements beside coarse ones: the square of a length, say.
  SurfaceMesh graded = shapes::sheet(12, true);
  for (Vec3& p : graded.points)
  {
    p = Vec3(std::pow(p.x(), 1.3), std::pow(p.y(), 1.3), 0.0);
  }
  const auto result = withoutSlivers(graded);
  EXPECT_TRUE(!result || result->vertexCount() == graded.vertexCount());
}

TEST(SliverRemoval, ChangesNothingFarAway)
{
  const SurfaceMesh good = icosphere(3);
  const SurfaceMesh spoilt = shapes::withCap(good, 100, 1e-4);
  const Vec3 place = good.facePoint(100, 0);
  const SurfaceMesh result = withoutSlivers(spoilt).value();
  for (const Vec3& p : good.points)
  {
    const bool isThere =
      std::find(result.points.begin(), result.points.end(), p) != result.points.end();
    EXPECT_TRUE(isThere || (p - place).norm() < 3.0 * meanEdgeLength(good));
  }
}

TEST(SliverRemoval, KeepsThinPlates)
{
  for (const double thickness : { 0.1, 1e-3, 1e-6 })
  {
    const SurfaceMesh thin = plate(thickness);
    ASSERT_LT(smallestAngle(thin), 6.0);
    const SurfaceMesh result = withoutSlivers(thin).value_or(thin);
    EXPECT_NEAR(signedVolume(result), signedVolume(thin), 1e-12 * thickness);
    EXPECT_EQ(boundingBox(result).diagonal(), boundingBox(thin).diagonal());
  }
}

TEST(SliverRemoval, KeepsTheShapeOfABoundary)
{
  const SurfaceMesh disc = shapes::disc(8);
  const SurfaceMesh spoilt = shapes::withNeedles(disc, 5, 0.02);
  const SurfaceMesh result = withoutSlivers(spoilt).value();
  EXPECT_GT(smallestAngle(result), 15.0);
  EXPECT_EQ(editing::kindOf(result), editing::kindOf(spoilt));
  EXPECT_LT(farthestFrom(result, spoilt.points), 0.02 * meanEdgeLength(disc));
  const SurfaceMesh square = shapes::withNeedles(shapes::sheet(8, true), 5, 0.02);
  const SurfaceMesh kept = withoutSlivers(square).value();
  for (const Vec3& corner : { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0) })
  {
    EXPECT_EQ(std::count(kept.points.begin(), kept.points.end(), corner), 1);
  }
  EXPECT_NEAR(surfaceArea(kept), 1.0, 1e-12);
}

TEST(SliverRemoval, RefusesWhatIsNoManifoldOfTriangles)
{
  EXPECT_THROW(withoutSlivers(cubeSphere(3)), InputError);
}
