// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/LeastAreaCap.h"

#include "Mesh/Angles.h"
#include "Mesh/MeshQuality.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/SurfaceMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;

namespace
{

bool allowAll(Index /*a*/, Index /*b*/)
{
  return true;
}

SurfaceMesh capMesh(const std::vector<Vec3>& corners)
{
  SurfaceMesh mesh;
  mesh.points = corners;
  for (const std::array<Index, 3>& t : leastAreaCap(corners, allowAll))
  {
    mesh.addFace({ t[0], t[1], t[2] });
  }
  return mesh;
}

/// A comb with long teeth: no diagonal but a few lies inside.
std::vector<Vec3> comb(int teeth)
{
  std::vector<Vec3> corners{ { 0.0, -0.3, 0.0 }, { 2.0 * teeth - 1.0, -0.3, 0.0 } };
  for (int tooth = teeth - 1; tooth >= 0; --tooth)
  {
    corners.emplace_back(2.0 * tooth + 1.0, 5.0, 0.0);
    corners.emplace_back(2.0 * tooth, 5.0, 0.0);
    if (tooth > 0)
    {
      corners.emplace_back(2.0 * tooth, 0.0, 0.0);
      corners.emplace_back(2.0 * tooth - 1.0, 0.0, 0.0);
    }
  }
  return corners;
}

double signedArea(const SurfaceMesh& planar)
{
  double area = 0.0;
  for (Index face = 0; face < planar.faceCount(); ++face)
  {
    area += faceVectorArea(planar, face).z();
  }
  return area;
}

} // namespace

TEST(LeastAreaCap, OfAPlanarPolygonCoversItOnce)
{
  const SurfaceMesh cap = capMesh(comb(6));
  EXPECT_EQ(cap.faceCount(), cap.vertexCount() - 2);
  // Equal sums of signed and unsigned areas: no triangle lies on another.
  EXPECT_NEAR(surfaceArea(cap), 6 * 5.0 + 11.0 * 0.3, 1e-12);
  EXPECT_NEAR(signedArea(cap), surfaceArea(cap), 1e-12);
  EXPECT_TRUE(selfIntersections(cap).empty());
}

TEST(LeastAreaCap, MakesNoTriangleOfCornersOnALine)
{
  std::vector<Vec3> square;
  for (const Vec3& corner : { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0) })
  {
    const Vec3 along(corner.y() > 0.5 ? -(corner.x() > 0.5) : (corner.x() < 0.5),
      corner.x() > 0.5 ? (corner.y() < 0.5) : -(corner.y() > 0.5), 0.0);
    for (int k = 0; k < 10; ++k)
    {
      square.push_back(corner + 0.1 * k * along);
    }
  }
  const SurfaceMesh cap = capMesh(square);
  EXPECT_EQ(cap.faceCount(), 38);
  EXPECT_NEAR(surfaceArea(cap), 1.0, 1e-12);
  for (Index face = 0; face < cap.faceCount(); ++face)
  {
    EXPECT_GT(smallestAngle(cap, face), 2.0);
  }
}

TEST(LeastAreaCap, SpansASaddleWithLessAreaThanAFan)
{
  std::vector<Vec3> rim;
  for (int k = 0; k < 40; ++k)
  {
    const double angle = 2.0 * Pi * k / 40;
    rim.emplace_back(std::cos(angle), std::sin(angle), 0.8 * std::cos(2.0 * angle));
  }
  double fan = 0.0;
  for (const std::size_t k : { 0U, 5U })
  {
    double area = 0.0;
    for (std::size_t j = 1; j < 39; ++j)
    {
      const Vec3& tip = rim[k];
      area += 0.5 * (rim[(k + j) % 40] - tip).cross(rim[(k + j + 1) % 40] - tip).norm();
    }
    fan = k == 0 ? area : std::min(fan, area);
  }
  const SurfaceMesh cap = capMesh(rim);
  EXPECT_LT(surfaceArea(cap), 0.95 * fan);
  EXPECT_TRUE(selfIntersections(cap).empty());
}

TEST(LeastAreaCap, KeepsToAllowedDiagonals)
{
  const std::vector<Vec3> square{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  for (const Index banned : { 0, 1 })
  {
    const auto cap = leastAreaCap(square, [&](Index a, Index) { return a != banned; });
    ASSERT_EQ(cap.size(), 2U);
    for (const std::array<Index, 3>& t : cap)
    {
      EXPECT_TRUE(std::count(t.begin(), t.end(), banned) == 0 ||
        std::count(t.begin(), t.end(), banned + 2) == 0);
    }
  }
  EXPECT_TRUE(leastAreaCap(square, [](Index, Index) { return false; }).empty());
}
