// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/Angles.h"
#include "Mesh/MeshTopology.h"
#include "Redistribution/SurfaceCurves.h"
#include "Shapes/Sheets.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;

namespace
{

double radiusOne(double)
{
  return 1.0;
}

} // namespace

TEST(SurfaceCurves, FindsTheSidesAndCornersOfASheet)
{
  const SurfaceMesh mesh = shapes::sheet(5, true);
  const SurfaceCurves curves(mesh, MeshTopology(mesh));
  EXPECT_EQ(curves.chains().size(), 4u);
  for (const VertexChain& chain : curves.chains())
  {
    EXPECT_FALSE(chain.isClosed);
    EXPECT_EQ(chain.edgeCount(), 5);
    EXPECT_TRUE(curves.isCorner(chain.vertices.front()));
    EXPECT_TRUE(curves.isCorner(chain.vertices.back()));
  }
  EXPECT_FALSE(curves.isOnCurve(7));
  EXPECT_TRUE(curves.isOnCurve(3));
  EXPECT_FALSE(curves.isCorner(3));
}

TEST(SurfaceCurves, FindsClosedBoundaries)
{
  const SurfaceMesh mesh = shapes::tube(12, 4, 1.0, radiusOne);
  const SurfaceCurves curves(mesh, MeshTopology(mesh));
  ASSERT_EQ(curves.chains().size(), 2u);
  EXPECT_TRUE(curves.chains()[0].isClosed);
  EXPECT_EQ(curves.chains()[0].edgeCount(), 12);
}

TEST(SurfaceCurves, FindsTheCreasesOfABox)
{
  const SurfaceMesh mesh = subdividedBox(4);
  const MeshTopology topology(mesh);
  const SurfaceCurves curves(mesh, topology, 40.0);
  EXPECT_EQ(curves.chains().size(), 12u);
  int corners = 0;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    corners += curves.isCorner(v) ? 1 : 0;
  }
  EXPECT_EQ(corners, 8);
  EXPECT_TRUE(SurfaceCurves(mesh, topology, 100.0).chains().empty());
}

TEST(SurfaceCurves, SlidingStaysOnThePolylineAndKeepsTheOrder)
{
  const SurfaceMesh mesh = shapes::tube(12, 4, 1.0, radiusOne);
  const SurfaceCurves curves(mesh, MeshTopology(mesh));
  SurfaceCurves::Positions positions = curves.startPositions();
  std::vector<Vec3> points = mesh.points;
  std::vector<Vec3> velocity;
  for (const Vec3& p : mesh.points)
  {
    velocity.push_back(Vec3(-p.y(), p.x(), 0.0) * (1.0 + 0.9 * p.x()));
  }
  for (int step = 0; step < 300; ++step) // several times round
  {
    curves.slide(velocity, 0.1, positions, points);
  }
  const double apothem = std::cos(Pi / 12.0);
  for (const VertexChain& chain : curves.chains())
  {
    double turned = 0.0;
    for (Index k = 0; k < chain.size(); ++k)
    {
      const Vec3& p = points[static_cast<std::size_t>(chain.vertex(k))];
      const Vec3& q = points[static_cast<std::size_t>(chain.vertex(k + 1))];
      EXPECT_NEAR(std::abs(p.z()), 1.0, 1e-14);
      EXPECT_LE(p.head<2>().norm(), 1.0 + 1e-12);
      EXPECT_GE(p.head<2>().norm(), apothem - 1e-12);
      turned += std::atan2(p.cross(q).z(), p.head<2>().dot(q.head<2>()));
    }
    EXPECT_NEAR(std::abs(turned), 2.0 * Pi, 1e-9); // once round, in order
  }
}

TEST(SurfaceCurves, CornersAndUnmovedVerticesKeepTheirBits)
{
  const SurfaceMesh mesh = shapes::sheet(5, true);
  const SurfaceCurves curves(mesh, MeshTopology(mesh));
  SurfaceCurves::Positions positions = curves.startPositions();
  std::vector<Vec3> points = mesh.points;
  std::vector<Vec3> velocity(points.size(), Vec3::Zero());
  velocity[0] = Vec3(1, 1, 0); // a corner
  velocity[2] = Vec3(0, 5, 3); // across its curve
  velocity[3] = Vec3(0.02, 0, 0);
  curves.slide(velocity, 1.0, positions, points);
  EXPECT_NEAR(points[3].x(), 0.62, 1e-14);
  points[3] = mesh.points[3];
  EXPECT_TRUE(points == mesh.points);
}
