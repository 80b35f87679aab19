// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/CutTriangles.h"

#include "Mesh/SelfIntersections.h"
#include "Mesh/TopologySummary.h"
#include "Mesh/TriangleEdges.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <vector>

using namespace evolving;

namespace
{

CutTriangles cut(const SurfaceMesh& mesh, const Execution& execution = {})
{
  const auto pieces = cutCrossings(mesh, selfIntersections(mesh), execution);
  EXPECT_TRUE(pieces);
  return pieces.value_or(CutTriangles());
}

/// Two triangles: their common segment has one end on a side of each.
SurfaceMesh twoTriangles()
{
  return shapes::merged(shapes::triangleMesh({ 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }),
    shapes::triangleMesh({ 1, 1.1, -1 }, { 1, 1.1, 1 }, { 5, 5, 0.1 }));
}

/// Larger triangles than the space between them.
SurfaceMesh crowd(int count, unsigned seed)
{
  std::mt19937 generator(seed);
  SurfaceMesh mesh;
  for (int i = 0; i < count; ++i)
  {
    mesh = shapes::merged(mesh,
      shapes::triangleMesh(shapes::randomPoint(generator), shapes::randomPoint(generator),
        shapes::randomPoint(generator)));
  }
  return mesh;
}

double areaOf(const SurfaceMesh& mesh, const std::vector<Index>& oldFace, Index face)
{
  double area = 0.0;
  for (Index piece = 0; piece < mesh.faceCount(); ++piece)
  {
    area += oldFace[at(piece)] == face ? faceVectorArea(mesh, piece).norm() : 0.0;
  }
  return area;
}

} // namespace

TEST(CutTriangles, MeetInOneEdgeWhereTwoCross)
{
  const CutTriangles pieces = cut(twoTriangles());
  const TriangleEdges edges(pieces.mesh);
  int crossing = 0;
  for (Index edge = 0; edge < edges.edgeCount(); ++edge)
  {
    crossing += edges.faceCount(edge) == 4 ? 1 : 0;
  }
  EXPECT_EQ(crossing, 1);
  EXPECT_TRUE(selfIntersections(pieces.mesh).empty());
}

TEST(CutTriangles, ArePiecesOfTheWhole)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    const SurfaceMesh mesh = crowd(30, seed);
    const CutTriangles pieces = cut(mesh);
    ASSERT_EQ(pieces.oldFace.size(), at(pieces.mesh.faceCount()));
    EXPECT_GT(pieces.mesh.faceCount(), 10 * mesh.faceCount());
    for (Index face = 0; face < mesh.faceCount(); ++face)
    {
      EXPECT_NEAR(
        areaOf(pieces.mesh, pieces.oldFace, face), faceVectorArea(mesh, face).norm(), 1e-8);
    }
    for (Index piece = 0; piece < pieces.mesh.faceCount(); ++piece)
    {
      const Vec3 turn = faceVectorArea(mesh, pieces.oldFace[at(piece)]);
      EXPECT_GT(faceVectorArea(pieces.mesh, piece).dot(turn), -1e-12);
    }
  }
}

/// Where three cross in a point, all three have it: no pair is left that crosses.
TEST(CutTriangles, DoNotCrossAnyMore)
{
  std::size_t before = 0;
  std::size_t after = 0;
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    const SurfaceMesh mesh = crowd(30, seed);
    const CutTriangles pieces = cut(mesh);
    before += selfIntersections(mesh).size();
    const TriangleEdges edges(pieces.mesh);
    // What crosses by rounding crosses in no point that is farther than that from an edge.
    for (const auto& [a, b] : selfIntersections(pieces.mesh))
    {
      int shared = 0;
      for (Index i = 0; i < 9; ++i)
      {
        shared += pieces.mesh.faceVertex(a, i / 3) == pieces.mesh.faceVertex(b, i % 3) ? 1 : 0;
      }
      after += shared == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(before, 500U);
  EXPECT_EQ(after, 0U);
}

TEST(CutTriangles, AreAsManyOnAnySideOfAnEdgeOfThree)
{
  // Every edge inside a crowd belongs to pieces of one triangle, or of two that cross: 2 or 4.
  const CutTriangles pieces = cut(crowd(40, 5));
  const TriangleEdges edges(pieces.mesh);
  for (Index edge = 0; edge < edges.edgeCount(); ++edge)
  {
    const Index count = edges.faceCount(edge);
    EXPECT_TRUE(count == 1 || count == 2 || count == 4) << count;
  }
}

TEST(CutTriangles, ThatOnlyTouchAreNot)
{
  const SurfaceMesh touching =
    shapes::merged(shapes::triangleMesh({ 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }),
      shapes::triangleMesh({ 1, 1, 0 }, { 1, 2, 1 }, { 2, 1, 1 }));
  EXPECT_FALSE(cutCrossings(touching, selfIntersections(touching)));
}

TEST(CutTriangles, OnThreadsAreTheSame)
{
  const SurfaceMesh mesh = crowd(60, 11);
  const CutTriangles alone = cut(mesh);
  for (const int threads : { 2, 8 })
  {
    const CutTriangles pieces = cut(mesh, threadedExecution(threads, 1));
    EXPECT_EQ(pieces.mesh, alone.mesh);
    EXPECT_EQ(pieces.oldFace, alone.oldFace);
  }
}
