// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/PointWelding.h"
#include "Mesh/SurfaceMesh.h"
#include "Mesh/TopologySummary.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace evolving
{

using namespace evolving::shapes;

namespace
{

TEST(PointWelding, GivesASoupItsTopologyBack)
{
  for (const SurfaceMesh& shape : { unitCube(), unitIcosphere(2), quadTorus(9, 6, 2.0, 0.5) })
  {
    const SurfaceMesh welded = weldCoincidentPoints(soupOf(shape));
    const TopologySummary expected = summarizeTopology(shape);
    const TopologySummary found = summarizeTopology(welded);
    EXPECT_EQ(welded.vertexCount(), shape.vertexCount());
    EXPECT_EQ(welded.faceCount(), shape.faceCount());
    EXPECT_EQ(found.edges, expected.edges);
    EXPECT_TRUE(found.isClosed());
    EXPECT_TRUE(found.isOriented());
    EXPECT_NEAR(signedVolume(welded), signedVolume(shape), 1e-14);
  }
}

TEST(PointWelding, ChangesNothingInAWeldedMesh)
{
  const SurfaceMesh shape = unitIcosphere(1);
  std::vector<Index> oldVertex;
  std::vector<Index> oldFace;
  const SurfaceMesh welded = weldCoincidentPoints(shape, &oldVertex, &oldFace);
  EXPECT_EQ(welded.points, shape.points);
  EXPECT_EQ(welded.faceOffsets, shape.faceOffsets);
  EXPECT_EQ(welded.cornerVertices, shape.cornerVertices);
  for (Index v = 0; v < shape.vertexCount(); ++v)
  {
    EXPECT_EQ(oldVertex[static_cast<std::size_t>(v)], v);
  }
  EXPECT_EQ(oldFace.size(), static_cast<std::size_t>(shape.faceCount()));
}

TEST(PointWelding, NumbersLeadBackToTheOldMesh)
{
  std::mt19937 generator(3);
  const SurfaceMesh soup = soupOf(triangulated(quadTorus(8, 5, 2.0, 0.5), generator));
  std::vector<Index> oldVertex{ 99 };
  std::vector<Index> oldFace{ 99 };
  const SurfaceMesh welded = weldCoincidentPoints(soup, &oldVertex, &oldFace);
  ASSERT_EQ(oldVertex.size(), welded.points.size());
  ASSERT_EQ(oldFace.size(), static_cast<std::size_t>(welded.faceCount()));
  EXPECT_TRUE(std::is_sorted(oldVertex.begin(), oldVertex.end()));
  for (std::size_t v = 0; v < oldVertex.size(); ++v)
  {
    EXPECT_EQ(welded.points[v], soup.points[static_cast<std::size_t>(oldVertex[v])]);
  }
  for (Index face = 0; face < welded.faceCount(); ++face)
  {
    const Index old = oldFace[static_cast<std::size_t>(face)];
    for (Index k = 0; k < 3; ++k)
    {
      EXPECT_EQ(welded.facePoint(face, k), soup.facePoint(old, k));
    }
  }
}

TEST(PointWelding, JoinsNegativeZeroToZero)
{
  const SurfaceMesh soup = makeMesh({ { 0.0, 0.0, 0.0 }, { 1, 0, 0 }, { 0, 1, 0 },
                                      { -0.0, 0.0, -0.0 }, { 0, 1, -0.0 }, { -1, 0, 0 } },
    { { 0, 1, 2 }, { 3, 4, 5 } });
  EXPECT_EQ(weldCoincidentPoints(soup).vertexCount(), 4);
}

TEST(PointWelding, KeepsPointsApartThatDifferInTheLastBit)
{
  SurfaceMesh soup = soupOf(unitCube());
  soup.points[0].x() += std::numeric_limits<double>::denorm_min();
  soup.points[3].y() = std::nextafter(soup.points[3].y(), 2.0);
  EXPECT_EQ(weldCoincidentPoints(soup).vertexCount(), 10);
}

TEST(PointWelding, DropsFacesThatCollapse)
{
  // A sliver with two equal points, one with all equal, and a quad that becomes a triangle.
  const SurfaceMesh soup =
    makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 1, 1, 0 }, { 0, 0, 0 } },
      { { 0, 1, 4 }, { 2, 3, 2 }, { 0, 1, 2, 3 }, { 4, 1, 2, 0 } });
  std::vector<Index> oldFace;
  const SurfaceMesh welded = weldCoincidentPoints(soup, nullptr, &oldFace);
  EXPECT_EQ(oldFace, (std::vector<Index>{ 2, 3 }));
  EXPECT_EQ(welded.cornerVertices, (std::vector<Index>{ 0, 1, 2, 0, 1, 2 }));
  EXPECT_EQ(welded.faceOffsets, (std::vector<Index>{ 0, 3, 6 }));
}

TEST(PointWelding, DropsPolygonsThatMeetAVertexTwice)
{
  // An hourglass and a spike: no disc, so no face.
  const SurfaceMesh soup = makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 0, 0 },
                                      { -1, 0, 0 }, { -1, -1, 0 }, { 1, 0, 0 } },
    { { 0, 1, 2, 3, 4, 5 }, { 0, 1, 2, 6 }, { 0, 1, 2 } });
  std::vector<Index> oldFace;
  const SurfaceMesh welded = weldCoincidentPoints(soup, nullptr, &oldFace);
  EXPECT_EQ(oldFace, (std::vector<Index>{ 2 }));
  EXPECT_EQ(welded.vertexCount(), 3);
}

TEST(PointWelding, KeepsDuplicateFaces)
{
  SurfaceMesh mesh = cornerTetrahedron();
  mesh.addFace({ 1, 2, 3 });
  mesh.addFace({ 3, 2, 1 });
  EXPECT_EQ(weldCoincidentPoints(soupOf(mesh)).faceCount(), 6);
}

TEST(PointWelding, DropsUnusedPointsEvenIfTheyAreNotNumbers)
{
  // They have no place in any order of the points, so they must stay out of it.
  const SurfaceMesh shape = unitIcosphere(2);
  const SurfaceMesh soup = soupOf(shape);
  SurfaceMesh mesh;
  for (Index face = 0; face < soup.faceCount(); ++face)
  {
    std::vector<Index> vertices;
    for (Index k = 0; k < 3; ++k)
    {
      mesh.addPoint(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
      vertices.push_back(mesh.addPoint(soup.facePoint(face, k)));
    }
    mesh.addFace(vertices);
  }
  const SurfaceMesh welded = weldCoincidentPoints(mesh);
  EXPECT_EQ(welded.vertexCount(), shape.vertexCount());
  EXPECT_TRUE(summarizeTopology(welded).isClosed());
}

TEST(PointWelding, FindsTheFirstOfEqualPointsAmongSome)
{
  const std::vector<Vec3> points = { Vec3(1, 0, 0), Vec3(0, 0, 0), Vec3(1, 0, 0),
    Vec3(-0.0, 0, -0.0), Vec3(1, 0, 0) };
  EXPECT_EQ(firstOfEqualPoints(points, { 0, 1, 2, 3, 4 }), (std::vector<Index>{ 0, 1, 0, 1, 0 }));
  EXPECT_EQ(
    firstOfEqualPoints(points, { 4, 2 }), (std::vector<Index>{ NoIndex, NoIndex, 2, NoIndex, 2 }));
}

TEST(PointWelding, FindsTheVertexOfEachPoint)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Vec3> vertices = { Vec3(1, 0, 0), Vec3(0, 0, 0) };
  const std::vector<Vec3> points = { Vec3(0, -0.0, 0), Vec3(2, 0, 0), Vec3(nan, 0, 0),
    Vec3(1, 0, 0), Vec3(2, 0, 0) };
  EXPECT_EQ(
    vertexOfEachPoint(points, vertices), (std::vector<Index>{ 1, NoIndex, NoIndex, 0, NoIndex }));
  EXPECT_TRUE(vertexOfEachPoint({}, vertices).empty());
  EXPECT_EQ(vertexOfEachPoint(points, {}), std::vector<Index>(5, NoIndex));
}

} // namespace

} // namespace evolving
