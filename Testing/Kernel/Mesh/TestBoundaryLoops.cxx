// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/Angles.h"
#include "Mesh/BoundaryLoops.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

/// The part of the unit sphere with polar angles from `from` to `to`.
SurfaceMesh sphereZone(Index around, Index rows, double from, double to)
{
  SurfaceMesh mesh;
  for (Index i = 0; i <= rows; ++i)
  {
    const double polar = from + (to - from) * i / rows;
    for (Index j = 0; j < around; ++j)
    {
      const double angle = 2.0 * Pi * j / around;
      mesh.addPoint(
        { std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), std::cos(polar) });
    }
  }
  for (Index i = 0; i < rows; ++i)
  {
    for (Index j = 0; j < around; ++j)
    {
      const Index next = (j + 1) % around;
      mesh.addFace(
        { i * around + j, (i + 1) * around + j, (i + 1) * around + next, i * around + next });
    }
  }
  return mesh;
}

/// Some of the faces with their corners in reverse order.
SurfaceMesh withFacesFlipped(SurfaceMesh mesh, std::mt19937& generator)
{
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    if (generator() % 2 == 0)
    {
      const auto corners = mesh.cornerVertices.begin();
      std::reverse(corners + mesh.faceOffsets[static_cast<std::size_t>(face)],
        corners + mesh.faceOffsets[static_cast<std::size_t>(face) + 1]);
    }
  }
  return mesh;
}

std::set<std::set<Index>> vertexSets(const std::vector<BoundaryLoop>& loops)
{
  std::set<std::set<Index>> sets;
  for (const BoundaryLoop& loop : loops)
  {
    sets.emplace(loop.vertices.begin(), loop.vertices.end());
    EXPECT_EQ(
      std::set<Index>(loop.vertices.begin(), loop.vertices.end()).size(), loop.vertices.size());
  }
  return sets;
}

} // namespace

TEST(BoundaryLoops, AreNoneOnClosedSurfaces)
{
  EXPECT_TRUE(boundaryLoops(unitCube()).empty());
  EXPECT_TRUE(boundaryLoops(quadTorus(12, 8, 2.0, 0.5)).empty());
  EXPECT_TRUE(boundaryLoops(SurfaceMesh()).empty());
}

TEST(BoundaryLoops, OfARingAreAHoleAndAnOutline)
{
  const std::vector<BoundaryLoop> loops = boundaryLoops(annulus(40));
  ASSERT_EQ(loops.size(), 2U);
  for (const BoundaryLoop& loop : loops)
  {
    const bool isHole = loop.diameter < 3.0;
    const double radius = isHole ? 1.0 : 2.0;
    EXPECT_EQ(loop.vertices.size(), 40U);
    EXPECT_NEAR(loop.diameter, 2.0 * radius, 1e-12);
    EXPECT_NEAR(loop.perimeter, 80.0 * radius * std::sin(Pi / 40.0), 1e-12);
    // Along the faces of a ring seen from above the outline runs counter-clockwise.
    const double area = 20.0 * radius * radius * std::sin(Pi / 20.0);
    EXPECT_NEAR(std::abs(loop.vectorArea.z()), area, 1e-12);
    EXPECT_NEAR(loop.continuation, isHole ? 1.0 : -1.0, 1e-12);
  }
  EXPECT_LT(loops[0].vectorArea.z() * loops[1].vectorArea.z(), 0.0);
}

TEST(BoundaryLoops, ContinuationIsTheCosineOfTheTurnToACap)
{
  for (const double hole : { 0.2, 0.7, 1.2, Pi / 2.0 })
  {
    const Index rows = 30;
    const SurfaceMesh mesh = sphereZone(48, rows, hole, Pi - 0.1);
    const double halfRow = 0.5 * (Pi - 0.1 - hole) / rows;
    const std::vector<BoundaryLoop> loops = boundaryLoops(mesh);
    ASSERT_EQ(loops.size(), 2U);
    // The first row of quads leans by half a row more; its width on the circle hardly matters.
    EXPECT_NEAR(loops[0].continuation, std::cos(hole + halfRow), 0.003) << hole;
    EXPECT_NEAR(loops[0].diameter, 2.0 * std::sin(hole), 1e-12);
  }
}

TEST(BoundaryLoops, DoNotDependOnOrientationOrNumbering)
{
  std::mt19937 generator(3);
  const SurfaceMesh mesh = facesWhere(
    unitIcosphere(3), [](const Vec3& p) { return p.z() < 0.8 && p.x() < 0.85 && p.y() > -0.9; });
  const std::vector<BoundaryLoop> loops = boundaryLoops(mesh);
  ASSERT_EQ(loops.size(), 3U);
  const std::vector<BoundaryLoop> mixed = boundaryLoops(withFacesFlipped(mesh, generator));
  EXPECT_EQ(vertexSets(mixed), vertexSets(loops));
  for (std::size_t k = 0; k < loops.size(); ++k)
  {
    EXPECT_NEAR(mixed[k].continuation, loops[k].continuation, 1e-12);
    EXPECT_NEAR(mixed[k].vectorArea.norm(), loops[k].vectorArea.norm(), 1e-12);
    EXPECT_EQ(mixed[k].diameter, loops[k].diameter);
    EXPECT_GT(loops[k].continuation, 0.7);
  }
  const std::vector<BoundaryLoop> turned = boundaryLoops(reversed(mesh));
  for (std::size_t k = 0; k < loops.size(); ++k)
  {
    EXPECT_NEAR((turned[k].vectorArea + loops[k].vectorArea).norm(), 0.0, 1e-12);
  }
}

TEST(BoundaryLoops, FollowMostOfTheirFaces)
{
  SurfaceMesh mesh = fan(12);
  const BoundaryLoop before = boundaryLoops(mesh).front();
  EXPECT_GT(before.vectorArea.z(), 0.0);
  std::reverse(mesh.cornerVertices.begin() + 3, mesh.cornerVertices.begin() + 6);
  const BoundaryLoop after = boundaryLoops(mesh).front();
  EXPECT_EQ(after.vertices, before.vertices);
  EXPECT_NEAR(after.continuation, -1.0, 1e-12);
  EXPECT_NEAR(before.continuation, -1.0, 1e-12);
}

TEST(BoundaryLoops, ThatTouchInAVertexAreTakenApart)
{
  // Two squares that meet in vertex 12 are missing from a sheet of 4 by 4.
  const SurfaceMesh mesh = facesWhere(triangleSheet(5, 5),
    [](const Vec3& p)
    {
      const bool lower = p.x() > 1 && p.x() < 2 && p.y() > 1 && p.y() < 2;
      const bool upper = p.x() > 2 && p.x() < 3 && p.y() > 2 && p.y() < 3;
      return !lower && !upper;
    });
  const std::set<std::set<Index>> loops = vertexSets(boundaryLoops(mesh));
  EXPECT_EQ(loops.size(), 3U);
  EXPECT_EQ(loops.count({ 6, 7, 11, 12 }), 1U);
  EXPECT_EQ(loops.count({ 12, 13, 17, 18 }), 1U);
}

TEST(BoundaryLoops, LeaveOutWhatClosesNowhere)
{
  // Three triangles at the edge 0 1: six boundary edges, of which four make a loop.
  const std::vector<Vec3> points{ { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { -1, 1, 0 },
    { -1, -1, 0 } };
  const std::vector<BoundaryLoop> book =
    boundaryLoops(makeMesh(points, { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 } }));
  EXPECT_EQ(vertexSets(book), (std::set<std::set<Index>>{ { 0, 1, 2, 3 } }));
  // A closed surface with one triangle more: its two free edges close nowhere.
  SurfaceMesh finned = unitIcosphere(1);
  const Index tip = finned.addPoint(Vec3(0.0, 0.0, 3.0));
  finned.addFace({ finned.faceVertex(0, 0), finned.faceVertex(0, 1), tip });
  EXPECT_TRUE(boundaryLoops(finned).empty());
}

TEST(BoundaryLoops, DiameterIsTheLargestOfAllDistances)
{
  std::mt19937 generator(11);
  for (int trial = 0; trial < 20; ++trial)
  {
    SurfaceMesh mesh = fan(30);
    for (Vec3& point : mesh.points)
    {
      point += 0.8 * randomPoint(generator) + Vec3(300.0, 0.0, 0.0);
    }
    double largest = 0.0;
    for (std::size_t i = 1; i < mesh.points.size(); ++i)
    {
      for (std::size_t j = 1; j < i; ++j)
      {
        largest = std::max(largest, (mesh.points[i] - mesh.points[j]).norm());
      }
    }
    EXPECT_EQ(boundaryLoops(mesh).front().diameter, largest);
  }
}

TEST(BoundaryLoops, OfAMoebiusBandIsOne)
{
  const std::vector<BoundaryLoop> loops = boundaryLoops(moebiusBand(16));
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(loops[0].vertices.size(), 32U);
}
