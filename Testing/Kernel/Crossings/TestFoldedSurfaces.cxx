// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Surfaces whose triangles run through others that they share a vertex with.
 */

#include "Checks/WindingComparison.h"
#include "Crossings/CutTriangles.h"
#include "Crossings/OuterSurface.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/TopologySummary.h"
#include "Mesh/TriangleEdges.h"
#include "Shapes/FoldedShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "ThreadedExecution.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace evolving;

namespace
{

/// Points of faces that are outside of what the mesh winds around, on one side.
std::vector<Vec3> seenPoints(const SurfaceMesh& mesh)
{
  std::vector<Vec3> points;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    for (const Vec3& weights : { Vec3(0.6, 0.3, 0.1), Vec3(0.1, 0.7, 0.2), Vec3(0.2, 0.1, 0.7) })
    {
      const Vec3 point = weights[0] * mesh.facePoint(face, 0) +
        weights[1] * mesh.facePoint(face, 1) + weights[2] * mesh.facePoint(face, 2);
      const Vec3 step = 1e-4 * faceVectorArea(mesh, face).normalized();
      if (std::abs(checks::windingAround(mesh, point + step)) < 0.5)
      {
        points.push_back(point);
      }
    }
  }
  return points;
}

Index sharedVertices(const SurfaceMesh& mesh, Index a, Index b)
{
  Index shared = 0;
  for (Index i = 0; i < 9; ++i)
  {
    shared += mesh.faceVertex(a, i / 3) == mesh.faceVertex(b, i % 3) ? 1 : 0;
  }
  return shared;
}

/// Of pairs that share so many vertices.
std::size_t crossingPairs(const SurfaceMesh& mesh, Index shared)
{
  std::size_t count = 0;
  for (const auto& [a, b] : selfIntersections(mesh))
  {
    count += sharedVertices(mesh, a, b) == shared ? 1 : 0;
  }
  return count;
}

Index edgesOfFour(const SurfaceMesh& mesh)
{
  const TriangleEdges edges(mesh);
  Index count = 0;
  for (Index edge = 0; edge < edges.edgeCount(); ++edge)
  {
    count += edges.faceCount(edge) == 4 ? 1 : 0;
  }
  return count;
}

SurfaceMesh outer(const SurfaceMesh& mesh, const Execution& execution = {})
{
  const std::optional<SurfaceMesh> surface = outerSurface(mesh, execution);
  EXPECT_TRUE(surface);
  return surface.value_or(SurfaceMesh());
}

/// Is the surface closed, and does it wind once round where the mesh winds at all?
void expectUnion(const SurfaceMesh& mesh, const SurfaceMesh& surface)
{
  const TopologySummary topology = summarizeTopology(surface);
  EXPECT_EQ(topology.boundaryEdges, 0);
  EXPECT_TRUE(topology.isOriented());
  const checks::WindingComparison found = checks::compareWinding(mesh, surface, 400, 3);
  EXPECT_GT(found.inside, 10);
  EXPECT_EQ(found.different, 0);
}

} // namespace

TEST(FoldedSurfaces, OfTwoTrianglesAreCutFromTheirCommonVertex)
{
  const SurfaceMesh mesh =
    shapes::makeMesh({ { 0, 0, 0 }, { 4, -1, 0 }, { 4, 1, 0 }, { 2, 0.2, -1 }, { 3, 0.2, 2 } },
      { { 0, 1, 2 }, { 3, 4, 0 } });
  const auto cut = cutCrossings(mesh, selfIntersections(mesh));
  ASSERT_TRUE(cut);
  EXPECT_EQ(edgesOfFour(cut->mesh), 1);
  EXPECT_EQ(cut->mesh.vertexCount(), 6);
  // The side from (2, 0.2, -1) to (3, 0.2, 2) is at height 0 a third of its way.
  EXPECT_NEAR((cut->mesh.points.back() - Vec3(7.0 / 3.0, 0.2, 0)).norm(), 0.0, 1e-12);
  EXPECT_TRUE(selfIntersections(cut->mesh).empty());
  EXPECT_EQ(cut->isFullyCut, std::vector<char>(2, 1));
}

TEST(FoldedSurfaces, ThatOnlyTouchAreNotCut)
{
  // A corner of the second lies on the first.
  const SurfaceMesh mesh =
    shapes::makeMesh({ { 0, 0, 0 }, { 4, -1, 0 }, { 4, 1, 0 }, { 2, 0, 0 }, { 3, 0, 2 } },
      { { 0, 1, 2 }, { 3, 4, 0 } });
  EXPECT_FALSE(selfIntersections(mesh).empty());
  EXPECT_FALSE(cutCrossings(mesh, selfIntersections(mesh)));
}

TEST(FoldedSurfaces, OfAnUmbrellaDoNotCrossAnyMore)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    const SurfaceMesh mesh = shapes::umbrella(30, seed);
    ASSERT_GT(crossingPairs(mesh, 1), 40U);
    const auto cut = cutCrossings(mesh, selfIntersections(mesh));
    ASSERT_TRUE(cut);
    EXPECT_EQ(crossingPairs(cut->mesh, 0), 0U) << seed;
    EXPECT_NEAR(surfaceArea(cut->mesh), surfaceArea(mesh), 1e-8);
    const TriangleEdges edges(cut->mesh);
    for (Index edge = 0; edge < edges.edgeCount(); ++edge)
    {
      const Index count = edges.faceCount(edge);
      EXPECT_TRUE(count == 1 || count == 2 || count == 4) << count;
    }
  }
}

TEST(FoldedSurfaces, OfStarsAreTheirUnion)
{
  for (const double unevenness : { 0.05, 0.2 })
  {
    const SurfaceMesh mesh = shapes::starCones(unevenness);
    ASSERT_GT(crossingPairs(mesh, 1), 9U);
    expectUnion(mesh, outer(mesh));
  }
  // Nearly flat: a star of circumradius 1 has the area 1.12257, its cones a third of that each.
  EXPECT_NEAR(signedVolume(outer(shapes::starCones(1e-4))), 2.0 * 1.12257 / 3.0, 1e-3);
}

TEST(FoldedSurfaces, OfCrumpledBallsAreTheirUnion)
{
  std::size_t atVertices = 0;
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    const SurfaceMesh mesh = shapes::shaken(icosphere(1), 0.9, seed);
    atVertices += crossingPairs(mesh, 1);
    expectUnion(mesh, outer(mesh));
  }
  EXPECT_GT(atVertices, 300U);
}

/// Some wind twice and the other way.
TEST(FoldedSurfaces, OfCrumpledBallsInsideOutAreTheirUnion)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    const SurfaceMesh mesh = shapes::shaken(icosphere(1), 2.0, seed);
    expectUnion(mesh, outer(mesh));
  }
}

TEST(FoldedSurfaces, OfBoxesThatShareACornerAreTheirUnion)
{
  std::mt19937 generator(2);
  for (int i = 0; i < 10; ++i)
  {
    const SurfaceMesh box = shapes::box(Vec3::Zero(), Vec3(1, 1.2, 1.4));
    const SurfaceMesh mesh = weldCoincidentPoints(
      shapes::merged(box, shapes::mapped(box, shapes::randomRotation(generator))));
    ASSERT_EQ(mesh.vertexCount(), 15);
    expectUnion(mesh, outer(mesh));
  }
}

TEST(FoldedSurfaces, ThatRunThroughOtherPartsAreTheirUnion)
{
  for (unsigned seed = 0; seed < 5; ++seed)
  {
    const SurfaceMesh mesh = shapes::merged(shapes::starCones(0.1),
      shapes::shaken(shapes::transformed(icosphere(2), 0.7, Vec3(0.2, 0, 0)), 0.01, seed));
    expectUnion(mesh, outer(mesh));
  }
}

TEST(FoldedSurfaces, KeepWhatIsSeenWhereACrossingCannotBeCut)
{
  const SurfaceMesh mesh = shapes::boxesOfOnePart();
  ASSERT_TRUE(summarizeTopology(mesh).isClosed() && summarizeTopology(mesh).isOriented());
  const auto cut = cutCrossings(mesh, selfIntersections(mesh));
  ASSERT_TRUE(cut);
  EXPECT_LT(*std::min_element(cut->isFullyCut.begin(), cut->isFullyCut.end()), 1);
  const SurfaceMesh surface = outer(mesh);
  const AABBTree tree(surface);
  const std::vector<Vec3> seen = seenPoints(mesh);
  EXPECT_GT(seen.size(), 60U);
  for (const Vec3& point : seen)
  {
    EXPECT_LT(tree.closest(point).at.squaredDistance, 1e-20) << point.transpose();
  }
  // And no more of what is inside than pieces beside that place.
  EXPECT_GT(tree.closest(Vec3(0.2, 0.3, 0)).at.squaredDistance, 0.01);
}

TEST(FoldedSurfaces, OnThreadsAreTheSame)
{
  const SurfaceMesh mesh = shapes::shaken(icosphere(2), 0.5, 1);
  const SurfaceMesh alone = outer(mesh);
  EXPECT_EQ(outer(mesh, threadedExecution(2, 1)), alone);
  EXPECT_EQ(outer(mesh, threadedExecution(8, 1)), alone);
}
