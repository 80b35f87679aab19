// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/PolygonTriangulation.h"

#include "Mesh/Angles.h"

#include <gtest/gtest.h>

#include <cmath>

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
