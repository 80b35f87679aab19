// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/PolygonTriangulation.h"

#include "Errors.h"
#include "Mesh/Angles.h"
#include "Shapes/Draws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

using namespace evolving;

namespace
{

double areaOf(const std::vector<Vec3>& corners, const std::vector<std::array<Index, 3>>& triangles,
  double* smallest)
{
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles)
  {
    const auto point = [&](Index i) { return corners[static_cast<std::size_t>(i)]; };
    const double area = 0.5 * (point(b) - point(a)).cross(point(c) - point(a)).z();
    *smallest = std::min(*smallest, area);
    sum += area;
  }
  return sum;
}

double polygonArea(const std::vector<Vec3>& corners)
{
  double twice = 0.0;
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    twice += corners[k].cross(corners[(k + 1) % corners.size()]).z();
  }
  return 0.5 * twice;
}

using Triangles = std::vector<std::array<Index, 3>>;

/// The same by looking at all corners for each triangle: the ear with the shortest cut, else the
/// second corner.
Triangles clippedOneByOne(const std::vector<Vec3>& corners)
{
  Vec3 normal = Vec3::Zero();
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
  {
    normal += (corners[k] - corners[0]).cross(corners[k + 1] - corners[0]);
  }
  const auto area = [&](const Vec3& a, const Vec3& b, const Vec3& c)
  { return normal.dot((b - a).cross(c - a)); };
  std::vector<Index> left(corners.size());
  std::iota(left.begin(), left.end(), 0);
  const auto number = [&](std::size_t k) { return left[k % left.size()]; };
  const auto corner = [&](std::size_t k) { return corners[at(number(k))]; };
  Triangles triangles;
  while (left.size() > 2)
  {
    std::size_t best = 1;
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < left.size(); ++k)
    {
      const Vec3 a = corner(k + left.size() - 1);
      const Vec3 b = corner(k);
      const Vec3 c = corner(k + 1);
      bool isEar = (c - a).squaredNorm() < shortest && area(a, b, c) > 0.0;
      for (std::size_t n = k + 2; isEar && n < k + left.size() - 1; ++n)
      {
        const Vec3 p = corner(n);
        const auto enters = [&](const Vec3& next, const Vec3& last)
        {
          return (area(p, next, corner(n - 1)) > 0.0 && area(p, corner(n - 1), last) > 0.0) ||
            (area(p, next, corner(n + 1)) > 0.0 && area(p, corner(n + 1), last) > 0.0);
        };
        const bool isTwinOutside =
          (p == a && !enters(b, c)) || (p == b && !enters(c, a)) || (p == c && !enters(a, b));
        isEar = isTwinOutside || area(a, b, p) < 0.0 || area(b, c, p) < 0.0 || area(c, a, p) < 0.0;
      }
      best = isEar ? k : best;
      shortest = isEar ? (c - a).squaredNorm() : shortest;
    }
    triangles.push_back({ number(best + left.size() - 1), number(best), number(best + 1) });
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return triangles;
}

/// In a slanted plane far away.
std::vector<Vec3> slanted(const std::vector<Vec3>& corners)
{
  std::vector<Vec3> result;
  for (const Vec3& corner : corners)
  {
    result.push_back(Vec3(100, -200, 300) + corner.x() * Vec3(0.6, 0.0, 0.8) +
      corner.y() * Vec3(0.48, 0.8, -0.36) + corner.z() * Vec3(-0.64, 0.6, 0.48));
  }
  return result;
}

/// An arm of some turns about the origin, as wide as the gap beside it.
std::vector<Vec3> spiral(int count, double turns)
{
  std::vector<Vec3> corners;
  for (int k = 0; k < count; ++k)
  {
    const bool isOuter = k < count / 2;
    const double along = (isOuter ? k : count - 1 - k) / (0.5 * count);
    const double r = 1.0 + turns * along - (isOuter ? 0.0 : 0.5);
    const double angle = 2.0 * 3.14159265358979323846 * turns * along;
    corners.push_back(Vec3(r * std::cos(angle), r * std::sin(angle), 0));
  }
  return corners;
}

/// With long teeth.
std::vector<Vec3> comb(int teeth)
{
  std::vector<Vec3> corners{ Vec3(0, -1, 0), Vec3(teeth, -1, 0) };
  for (int k = teeth; k > 0; --k)
  {
    corners.insert(corners.end(), { Vec3(k - 0.1, 50, 0), Vec3(k - 0.5, 0, 0) });
  }
  return corners;
}

} // namespace

TEST(PolygonTriangulation, CoversAStarWithoutOverlap)
{
  std::vector<Vec3> star;
  for (int k = 0; k < 14; ++k)
  {
    const double r = k % 2 == 0 ? 1.0 : 0.3;
    const double angle = 2.0 * Pi * k / 14;
    star.push_back(Vec3(r * std::cos(angle), r * std::sin(angle), 0));
  }
  const auto triangles = triangulatePolygon(star);
  EXPECT_EQ(triangles.size(), 12U);
  double smallest = 1.0;
  EXPECT_NEAR(areaOf(star, triangles, &smallest), polygonArea(star), 1e-12);
  EXPECT_GT(smallest, 0.0);
}

TEST(PolygonTriangulation, CutsAnArrowAtItsNotch)
{
  const std::vector<Vec3> arrow{ Vec3(0, 0, 0), Vec3(2, 1, 0), Vec3(0, 2, 0), Vec3(1, 1, 0) };
  const auto triangles = triangulatePolygon(arrow);
  ASSERT_EQ(triangles.size(), 2U);
  double smallest = 1.0;
  EXPECT_NEAR(areaOf(arrow, triangles, &smallest), 1.0, 1e-12);
  EXPECT_GT(smallest, 0.0);
}

TEST(PolygonTriangulation, AcceptsCollinearAndCoincidentCorners)
{
  EXPECT_EQ(
    triangulatePolygon({ Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(2, 2, 0) }).size(), 2U);
  EXPECT_EQ(triangulatePolygon(std::vector<Vec3>(6, Vec3(1, 1, 1))).size(), 4U);
}

TEST(PolygonTriangulation, RemembersTheFaces)
{
  SurfaceMesh mesh;
  mesh.points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(2, 0, 0) };
  mesh.addFace({ 0, 1, 2, 3 });
  mesh.addFace({ 1, 4, 2 });
  std::vector<Index> oldFace;
  const SurfaceMesh triangles = triangulate(mesh, oldFace);
  EXPECT_TRUE(triangles.hasOnlyTriangles());
  EXPECT_EQ(oldFace, (std::vector<Index>{ 0, 0, 1 }));
  EXPECT_NEAR(surfaceArea(triangles), 1.5, 1e-12);
}

TEST(PolygonTriangulation, TakesTheShortestCutOfAllEars)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.2, 1.0);
  std::uniform_int_distribution<int> onLattice(-3, 3);
  std::vector<std::vector<Vec3>> polygons{ spiral(60, 2.5), comb(12) };
  for (int n = 0; n < 60; ++n)
  {
    std::vector<Vec3> star;    // simple, with notches; every third one is not planar
    std::vector<Vec3> tangled; // crosses itself, with equal and collinear corners
    for (int k = 0; k < 5 + n; ++k)
    {
      const double angle = 2.0 * 3.14159265358979323846 * k / (5 + n);
      const double height = n % 3 == 0 ? uniform(random) : 0.0;
      star.push_back(uniform(random) * Vec3(std::cos(angle), std::sin(angle), height));
      tangled.push_back(shapes::drawnInPlane(onLattice, random));
    }
    polygons.insert(
      polygons.end(), { star, tangled, std::vector<Vec3>(star.rbegin(), star.rend()) });
  }
  for (const std::vector<Vec3>& polygon : polygons)
  {
    EXPECT_EQ(triangulatePolygon(polygon), clippedOneByOne(polygon));
    EXPECT_EQ(triangulatePolygon(slanted(polygon)), clippedOneByOne(slanted(polygon)));
  }
}

TEST(PolygonTriangulation, CutsTensOfThousandsOfCorners)
{
  for (const std::vector<Vec3>& polygon : { spiral(30000, 20.0), comb(15000) })
  {
    const auto triangles = triangulatePolygon(polygon);
    EXPECT_EQ(triangles.size(), polygon.size() - 2);
    double smallest = 1.0;
    const double area = polygonArea(polygon);
    EXPECT_NEAR(areaOf(polygon, triangles, &smallest), area, 1e-9 * area);
    EXPECT_GE(smallest, 0.0);
  }
}

TEST(PolygonTriangulation, StopsWhenAsked)
{
  int questions = 0;
  const Execution stopping(nullptr, nullptr, [&] { return ++questions > 2; });
  EXPECT_THROW(triangulatePolygon(spiral(10000, 5.0), stopping), Cancelled);
  EXPECT_EQ(questions, 3);
}

TEST(PolygonTriangulation, OfManySmallFacesCanBeStopped)
{
  SurfaceMesh strip;
  constexpr Index Quads = 10000;
  for (Index k = 0; k <= Quads; ++k)
  {
    strip.addPoint(Vec3(k, 0.0, 0.0));
    strip.addPoint(Vec3(k, 1.0, 0.0));
  }
  for (Index k = 0; k < Quads; ++k)
  {
    strip.addFace({ 2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1 });
  }
  double told = 0.0;
  const Execution stopping(
    nullptr, [&](double fraction) { told = fraction; }, [&] { return told > 0.5; });
  std::vector<Index> oldFace;
  EXPECT_THROW(triangulate(strip, oldFace, stopping), Cancelled);
  EXPECT_LT(told, 0.6);
}

TEST(PolygonTriangulation, OfTooFewCornersOrOnesBeyondSquaresIsFinite)
{
  EXPECT_TRUE(triangulatePolygon({}).empty());
  EXPECT_TRUE(triangulatePolygon({ Vec3(0, 0, 0), Vec3(1, 0, 0) }).empty());
  for (const double scale : { 1e-200, 1e-100, 1e100, 1e200 })
  {
    std::vector<Vec3> polygon = spiral(100, 2.0);
    for (Vec3& corner : polygon)
    {
      corner *= scale;
    }
    EXPECT_EQ(triangulatePolygon(polygon).size(), 98U);
  }
}

/// A square with square holes, to which slits lead: both ends of a slit are corners twice.
TEST(PolygonTriangulation, LeavesHolesThatSlitsLeadTo)
{
  const auto at = [](double x, double y) { return Vec3(x, y, 0.0); };
  const std::vector<Vec3> oneHole = { at(0, 0), at(4, 0), at(4, 4), at(0, 4), at(0, 0), at(1, 1),
    at(1, 3), at(3, 3), at(3, 1), at(1, 1) };
  const std::vector<Vec3> twoHoles = { at(0, 0), at(1, 1), at(1, 2), at(2, 2), at(2, 1), at(1, 1),
    at(0, 0), at(9, 0), at(9, 4), at(8, 3), at(8, 1), at(5, 1), at(5, 3), at(8, 3), at(9, 4),
    at(0, 4) };
  for (std::vector<Vec3> polygon : { oneHole, twoHoles })
  {
    for (std::size_t first = 0; first < polygon.size(); ++first)
    {
      std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
      double smallest = 1.0;
      const auto triangles = triangulatePolygon(polygon);
      EXPECT_EQ(triangles.size(), polygon.size() - 2);
      EXPECT_NEAR(areaOf(polygon, triangles, &smallest), polygonArea(polygon), 1e-12);
      EXPECT_GE(smallest, 0.0) << "from corner " << first;
    }
  }
}
