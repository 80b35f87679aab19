// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/StarOptimization.h"

#include "Mesh/MeshQuality.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/FaceShape.h"
#include "Remeshing/ReferenceSurface.h"
#include "Remeshing/RemeshingShapes.h"
#include "Remeshing/StarSearch.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "StartSurface/QuadSplitting.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace
{

using namespace evolving;
using namespace evolving::editing;

/// The unit sphere itself, and curve 1 where it meets the plane z = 0.
class SphereWithEquator : public shapes::ExactSphere
{
public:
  Vec3 onCurve(const Vec3& point, Index /*curve*/) const override
  {
    return Vec3(point.x(), point.y(), 0.0).normalized();
  }
};

EditableSurface shakenSphere(unsigned seed)
{
  return shapes::sized(shapes::shakenSphere(4, 0.2, seed), 0.07);
}

TEST(StarOptimization, RaisesTheSmallestAngle)
{
  for (const unsigned seed : { 1U, 2U, 3U })
  {
    EditableSurface surface = shakenSphere(seed);
    EXPECT_LT(smallestAngle(surface.mesh()), 26.0);
    EXPECT_GT(optimizeStars(surface, SphereWithEquator(), 46.0, 15), 500);
    EXPECT_GT(smallestAngle(surface.mesh()), 40.0);
    expectSound(surface, { 2, 0, 1 });
  }
}

TEST(StarOptimization, NeverLowersTheSmallestAngleAnywhere)
{
  EditableSurface surface = shakenSphere(4);
  double last = smallestAngle(surface.mesh());
  for (int round = 0; round < 5; ++round)
  {
    optimizeStars(surface, SphereWithEquator(), 46.0, 1);
    const double now = smallestAngle(surface.mesh());
    EXPECT_GE(now, last);
    last = now;
  }
}

TEST(StarOptimization, HeightsStay)
{
  EditableSurface surface = shakenSphere(5);
  for (const Index v : verticesOf(surface))
  {
    surface.setPoint(v, (1.0 + 0.002 * std::sin(17.0 * v)) * surface.point(v));
  }
  EXPECT_GT(optimizeStars(surface, SphereWithEquator(), 46.0, 5), 500);
  for (const Index v : verticesOf(surface))
  {
    ASSERT_NEAR(surface.point(v).norm(), 1.0 + 0.002 * std::sin(17.0 * v), 1e-12);
  }
}

/// Every bad star is searched in every round, whatever has moved.
void optimizeAll(
  EditableSurface& surface, const ReferenceSurface& reference, double degrees, int rounds)
{
  for (int round = 0; round < rounds; ++round)
  {
    std::map<Index, double> angles;
    for (Index f = 0; f < surface.faceSlots(); ++f)
    {
      for (Index k = 0; k < 3; ++k)
      {
        double& angle = angles.emplace(surface.from(3 * f + k), 60.0).first->second;
        angle = std::min(angle, smallestAngle(surface, f));
      }
    }
    std::vector<std::pair<double, Index>> vertices;
    for (const auto& [v, angle] : angles)
    {
      if (angle < degrees)
      {
        vertices.emplace_back(angle, v);
      }
    }
    std::sort(vertices.begin(), vertices.end());
    for (const auto& [angle, v] : vertices)
    {
      StarSearch(surface, reference).improve(v);
    }
  }
}

TEST(StarOptimization, LeavesOutOnlyWhatWouldChangeNothing)
{
  constexpr double Unreachable = 57.0; // so that rounds go on
  const SphereWithEquator reference;
  for (const unsigned seed : { 8U, 9U })
  {
    EditableSurface surface = shapes::sized(shapes::shakenSphere(3, 0.2, seed), 0.14);
    EditableSurface expected = surface;
    optimizeAll(expected, reference, Unreachable, 20);
    optimizeStars(surface, reference, Unreachable, 20);
    for (const Index v : verticesOf(surface))
    {
      ASSERT_EQ(surface.point(v), expected.point(v)) << "vertex " << v;
    }
  }
}

TEST(StarSearch, MovesOnlyWhereTheSmallestAngleOfTheStarGrows)
{
  EditableSurface surface = shakenSphere(10);
  const SphereWithEquator reference;
  StarSearch search(surface, reference);
  Index moves = 0;
  for (const Index v : verticesOf(surface))
  {
    const double before = cosineOfSmallestAngleAround(surface, v);
    const bool hasMoved = search.improve(v);
    moves += hasMoved ? 1 : 0;
    EXPECT_TRUE(hasMoved ? cosineOfSmallestAngleAround(surface, v) < before
                         : cosineOfSmallestAngleAround(surface, v) == before)
      << v;
  }
  EXPECT_GT(moves, 500);
}

TEST(StarOptimization, OnlyBadStarsMove)
{
  EditableSurface surface = shakenSphere(6);
  const SurfaceMesh before = surface.mesh();
  optimizeStars(surface, SphereWithEquator(), 35.0, 1);
  for (const Index v : verticesOf(surface))
  {
    bool isBad = false;
    surface.forEachOutgoing(v,
      [&](Index e) { isBad = isBad || smallestAngle(before, EditableSurface::faceOf(e)) < 35.0; });
    if (!isBad)
    {
      ASSERT_EQ(surface.point(v), before.points[static_cast<std::size_t>(v)]);
    }
  }
  EditableSurface good = shapes::sized(icosphere(4), 0.07);
  EXPECT_EQ(optimizeStars(good, SphereWithEquator(), 40.0, 5), 0);
}

TEST(StarOptimization, CornersPinsAndBoundariesStay)
{
  const SurfaceMesh mesh = shapes::shakenInside(shapes::halfSphere(12), 0.02, 7);
  EditableSurface surface = shapes::sized(mesh, 0.12);
  for (Index v = 0; v < surface.vertexSlots(); v += 7)
  {
    surface.setPinned(v);
  }
  EXPECT_GT(optimizeStars(surface, SphereWithEquator(), 46.0, 3), 100);
  for (const Index v : verticesOf(surface))
  {
    if (surface.isPinned(v) || surface.isBoundary(v))
    {
      ASSERT_EQ(surface.point(v), mesh.points[static_cast<std::size_t>(v)]);
    }
  }
}

TEST(StarOptimization, VerticesOfCurvesSlide)
{
  // The cube-sphere has vertices along z = 0; they are pushed to and fro on that circle.
  SurfaceMesh mesh = splitQuads(cubeSphere(8));
  EditableSurface surface = shapes::sized(mesh, 0.15);
  for (const Index e : edgesOf(surface))
  {
    const auto isOn = [&](Index v) { return std::abs(surface.point(v).z()) < 1e-12; };
    if (isOn(surface.from(e)) && isOn(surface.to(e)))
    {
      surface.setCurve(e, 1);
    }
  }
  Index onCurve = 0;
  for (const Index v : verticesOf(surface))
  {
    if (surface.featureEdges(v) == 2)
    {
      const Vec3 aside = Vec3::UnitZ().cross(surface.point(v));
      surface.setPoint(v, (surface.point(v) + (v % 2 == 0 ? 0.05 : -0.05) * aside).normalized());
      ++onCurve;
    }
  }
  ASSERT_EQ(onCurve, 32);
  const SurfaceMesh before = surface.mesh();
  optimizeStars(surface, SphereWithEquator(), 46.0, 5);
  Index slid = 0;
  for (const Index v : verticesOf(surface))
  {
    if (surface.featureEdges(v) == 2)
    {
      ASSERT_EQ(surface.point(v).z(), 0.0);
      ASSERT_NEAR(surface.point(v).norm(), 1.0, 1e-14);
      slid += surface.point(v) != before.points[static_cast<std::size_t>(v)] ? 1 : 0;
    }
  }
  EXPECT_GT(slid, 10);
  EXPECT_GT(smallestAngle(surface.mesh()), smallestAngle(before));
}

TEST(StarOptimization, IsTheSameEveryTime)
{
  const OffsetReference reference(icosphere(4), 0.0);
  EditableSurface first = shakenSphere(8);
  optimizeStars(first, reference, 46.0, 3);
  EditableSurface second = shakenSphere(8);
  optimizeStars(second, reference, 46.0, 3, threadedExecution(8, 1));
  EXPECT_TRUE(first.mesh() == second.mesh());
}

} // namespace
