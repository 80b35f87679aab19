// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Operators/ElementShape.h"

#include "Mesh/Angles.h"
#include "Mesh/MeshTopology.h"
#include "Operators/SurfaceGeometry.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;

namespace
{

/// A polygon of given angles in the plane z = 0 around vertex 0, as triangles.
SurfaceMesh star(const std::vector<double>& angles, const Vec3& centre)
{
  SurfaceMesh mesh;
  mesh.addPoint(centre);
  for (const double angle : angles)
  {
    mesh.addPoint(Vec3(std::cos(angle), std::sin(angle), 0.0));
  }
  const auto count = static_cast<Index>(angles.size());
  for (Index k = 0; k < count; ++k)
  {
    mesh.addFace({ 0, 1 + k, 1 + (k + 1) % count });
  }
  return mesh;
}

SurfaceMesh unevenStar(const Vec3& centre)
{
  return star({ 0.1, 0.9, 2.0, 2.8, 4.0, 5.5 }, centre);
}

Vec3 moveOf(const SurfaceMesh& mesh, Index vertex, const Vec3& tangent = Vec3::Zero())
{
  const MeshTopology topology(mesh);
  SurfaceGeometry geometry(topology);
  geometry.update(mesh, Execution());
  return bestShapeMove(
    mesh, topology, vertex, geometry.normals()[static_cast<std::size_t>(vertex)], tangent);
}

/// The sum that the move of vertex 0 of a star is to lower: its faces are triangles.
double energyOf(const SurfaceMesh& mesh)
{
  double sum = 0.0;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    const double q = cornerShape(mesh.facePoint(face, 1) - mesh.facePoint(face, 0),
      mesh.facePoint(face, 2) - mesh.facePoint(face, 0), 3);
    sum += q * q;
  }
  return sum;
}

} // namespace

TEST(ElementShape, IsOneForRegularPolygonsOfAnySize)
{
  for (const Index size : { 3, 4, 5, 8 })
  {
    const double angle = Pi * (size - 2) / size;
    for (const double length : { 1e-20, 1.0, 1e20 })
    {
      const Vec3 e1(length, 0.0, 0.0);
      const Vec3 e2(length * std::cos(angle), length * std::sin(angle), 0.0);
      EXPECT_NEAR(cornerShape(e1, e2, size), 1.0, 1e-14) << size << " corners";
      EXPECT_GT(cornerShape(e1, 1.5 * e2, size), 1.01) << size << " corners";
    }
  }
}

TEST(ElementShape, OfATriangleIsTheSameAtItsThreeCorners)
{
  const Vec3 a(0.1, 0.2, 0.3);
  const Vec3 b(1.0, 0.4, -0.2);
  const Vec3 c(0.7, 1.3, 0.5);
  const double lengths = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  const double area = 0.5 * (b - a).cross(c - a).norm();
  const double expected = lengths / (4.0 * std::sqrt(3.0) * area); // Knupp's inverse mean ratio
  EXPECT_NEAR(cornerShape(b - a, c - a, 3), expected, 1e-14 * expected);
  EXPECT_NEAR(cornerShape(c - b, a - b, 3), expected, 1e-14 * expected);
  EXPECT_NEAR(cornerShape(a - c, b - c, 3), expected, 1e-14 * expected);
}

TEST(BestShapeMove, RestsInRegularRings)
{
  SurfaceMesh triangles = star({ 0.0, 1.0, 2.0, 3.0, 4.0, 5.0 }, Vec3::Zero());
  for (int k = 0; k < 6; ++k)
  {
    const double angle = k * Pi / 3.0;
    triangles.points[static_cast<std::size_t>(k + 1)] = Vec3(std::cos(angle), std::sin(angle), 0.0);
  }
  EXPECT_LT(moveOf(triangles, 0).norm(), 1e-15);
  EXPECT_LT(moveOf(shapes::sheet(4, false), 12).norm(), 1e-15); // a square's corner, valence 4
}

TEST(BestShapeMove, GoesToTheMinimumByNewtonsMethod)
{
  SurfaceMesh mesh = unevenStar(Vec3(0.35, -0.2, 0.0));
  std::vector<double> moves;
  for (int k = 0; k < 7; ++k)
  {
    const Vec3 move = moveOf(mesh, 0);
    mesh.points[0] += move;
    moves.push_back(move.norm());
  }
  EXPECT_GT(moves[0], 0.1);
  EXPECT_LT(moves[6], 1e-14);
  for (std::size_t k = 2; k < 5; ++k) // squares of the error, until rounding
  {
    EXPECT_LT(moves[k + 1], std::max(5.0 * moves[k] * moves[k], 1e-14)) << "step " << k;
  }
  const double least = energyOf(mesh);
  for (int k = 0; k < 8; ++k)
  {
    SurfaceMesh beside = mesh;
    beside.points[0] += 1e-3 * Vec3(std::cos(k * Pi / 4.0), std::sin(k * Pi / 4.0), 0.0);
    EXPECT_GT(energyOf(beside), least + 1e-7);
  }
}

TEST(BestShapeMove, LowersTheShapesOfABadStar)
{
  SurfaceMesh mesh = unevenStar(Vec3(0.95, 0.15, 0.0)); // close to a corner: a needle and a cap
  const double before = energyOf(mesh);
  mesh.points[0] += moveOf(mesh, 0);
  EXPECT_LT(energyOf(mesh), 0.6 * before);
}

TEST(BestShapeMove, TurnsAFoldedStarBack)
{
  SurfaceMesh mesh = unevenStar(Vec3(1.1, 0.6, 0.0)); // outside: one triangle is turned over
  const auto turned = [&]
  {
    int count = 0;
    for (Index face = 0; face < mesh.faceCount(); ++face)
    {
      count += faceVectorArea(mesh, face).z() <= 0.0 ? 1 : 0;
    }
    return count;
  };
  ASSERT_GT(turned(), 0);
  for (int k = 0; k < 50; ++k)
  {
    mesh.points[0] += 0.8 * moveOf(mesh, 0);
  }
  EXPECT_EQ(turned(), 0);
}

TEST(BestShapeMove, ScalesAndIsTangential)
{
  const SurfaceMesh mesh = shapes::bumpySphere(2);
  const MeshTopology topology(mesh);
  SurfaceGeometry geometry(topology);
  geometry.update(mesh, Execution());
  for (const double scale : { 1e-12, 1e12 })
  {
    const SurfaceMesh large = shapes::transformed(mesh, scale, Vec3::Zero());
    for (const Index vertex : { 0, 17, 101 })
    {
      const Vec3 move = moveOf(mesh, vertex);
      ASSERT_GT(move.norm(), 1e-3);
      EXPECT_LT((moveOf(large, vertex) / scale - move).norm(), 1e-12 * move.norm());
      EXPECT_LT(std::abs(move.dot(geometry.normals()[static_cast<std::size_t>(vertex)])), 1e-15);
    }
  }
}

TEST(BestShapeMove, FollowsACurve)
{
  const SurfaceMesh mesh = shapes::shakenSheet(6, true, 0.3, 4);
  const Vec3 tangent(0.6, 0.8, 0.0);
  const Vec3 move = moveOf(mesh, 24, tangent);
  EXPECT_GT(move.norm(), 1e-4);
  EXPECT_LT(move.cross(tangent).norm(), 1e-15);
}

TEST(BestShapeMove, IsFiniteForDegenerateElements)
{
  SurfaceMesh mesh = unevenStar(Vec3(0.2, 0.1, 0.0));
  mesh.points[2] = mesh.points[1];
  EXPECT_TRUE(moveOf(mesh, 0).allFinite());
  mesh.points[0] = mesh.points[1];
  EXPECT_TRUE(moveOf(mesh, 0).allFinite());
  for (Vec3& p : mesh.points)
  {
    p.setZero();
  }
  EXPECT_EQ(moveOf(mesh, 0), Vec3(Vec3::Zero()));
}
