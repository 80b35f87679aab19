// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/SelfIntersections.h"

#include "Errors.h"
#include "Mesh/TrianglePairs.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace evolving
{

using namespace evolving::shapes;

namespace
{

using Pairs = std::vector<std::pair<Index, Index>>;

TriangleVertices triangleOf(const SurfaceMesh& mesh, Index face)
{
  return { mesh.faceVertex(face, 0), mesh.faceVertex(face, 1), mesh.faceVertex(face, 2) };
}

Pairs allPairsReference(const SurfaceMesh& mesh)
{
  Pairs pairs;
  for (Index i = 0; i < mesh.faceCount(); ++i)
  {
    for (Index j = i + 1; j < mesh.faceCount(); ++j)
    {
      const TriangleVertices t = triangleOf(mesh, i);
      const TriangleVertices s = triangleOf(mesh, j);
      if (hasArea(mesh.points, t) && hasArea(mesh.points, s) &&
        intersectBeyondShared(mesh.points, t, s))
      {
        pairs.emplace_back(i, j);
      }
    }
  }
  return pairs;
}

/// Triangles of about the given sizes, mixed, some of which share vertices.
SurfaceMesh randomSoup(int count, const std::vector<double>& sizes, std::mt19937& generator)
{
  SurfaceMesh mesh;
  for (int i = 0; i < count; ++i)
  {
    const double size = sizes[static_cast<std::size_t>(i) % sizes.size()];
    const Vec3 place = randomPoint(generator);
    const Index first = i % 5 == 4 ? mesh.vertexCount() - 3 : mesh.addPoint(place);
    const Vec3 base = mesh.points[static_cast<std::size_t>(first)];
    const Index second = mesh.addPoint(base + size * randomPoint(generator));
    mesh.addFace({ first, second, mesh.addPoint(base + size * randomPoint(generator)) });
  }
  return mesh;
}

/// The sheet rolled up into a flat strip: columns of squares lie on each other in turns.
SurfaceMesh foldedSheet(Index rows, Index columns, Index foldEvery)
{
  SurfaceMesh sheet = triangleSheet(rows, columns);
  for (Vec3& point : sheet.points)
  {
    const double phase = std::fmod(point.x(), 2.0 * foldEvery);
    point.x() = phase <= foldEvery ? phase : 2.0 * foldEvery - phase;
  }
  return sheet;
}

TEST(SelfIntersections, NoneInEmbeddedSurfaces)
{
  std::mt19937 generator(53);
  for (const SurfaceMesh& mesh :
    { SurfaceMesh(), cornerTetrahedron(), unitIcosphere(0), unitIcosphere(4),
      triangulated(unitCube(), generator), triangleSheet(20, 30),
      triangulated(slabWithHoles(2), generator), triangulated(quadTorus(40, 20, 2, 0.7), generator),
      triangulated(moebiusBand(30), generator) })
  {
    EXPECT_TRUE(selfIntersections(mesh).empty());
    EXPECT_TRUE(selfIntersections(mapped(mesh, randomRotation(generator))).empty());
  }
}

TEST(SelfIntersections, AgreeWithAllPairsInRandomSoups)
{
  std::mt19937 generator(59);
  for (const std::vector<double>& sizes :
    { std::vector<double>{ 0.3 }, { 2.0 }, { 0.02, 0.02, 0.02, 0.02, 0.02, 3.0 }, { 1e-3, 1.0 } })
  {
    const SurfaceMesh soup = randomSoup(500, sizes, generator);
    const Pairs expected = allPairsReference(soup);
    EXPECT_GT(expected.size(), 20U);
    EXPECT_EQ(selfIntersections(soup), expected);
  }
}

TEST(SelfIntersections, OfTwoSpheresLieAlongTheirCircle)
{
  const SurfaceMesh sphere = unitIcosphere(3);
  const SurfaceMesh both = merged(sphere, transformed(sphere, 1.0, { 1.0, 0.01, 0.02 }));
  const Pairs pairs = selfIntersections(both);
  EXPECT_EQ(pairs, allPairsReference(both));
  EXPECT_GT(pairs.size(), 60U);
  for (const auto& pair : pairs)
  {
    EXPECT_LT(pair.first, sphere.faceCount());
    EXPECT_GE(pair.second, sphere.faceCount());
    EXPECT_NEAR(both.facePoint(pair.first, 0).x(), 0.5, 0.25);
  }
}

TEST(SelfIntersections, OfSpheresThatAreApartOrInsideEachOtherAreNone)
{
  const SurfaceMesh sphere = unitIcosphere(3);
  EXPECT_TRUE(
    selfIntersections(merged(sphere, transformed(sphere, 1.0, { 2.0001, 0, 0 }))).empty());
  EXPECT_TRUE(selfIntersections(merged(sphere, transformed(sphere, 0.98, Vec3::Zero()))).empty());
}

TEST(SelfIntersections, OfASheetFoldedFlat)
{
  // One fold of two triangles: each upper one lies on each lower one of its square.
  const SurfaceMesh once = foldedSheet(3, 2, 1);
  EXPECT_EQ(selfIntersections(once), allPairsReference(once));
  EXPECT_EQ(selfIntersections(once), (Pairs{ { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 } }));
  const SurfaceMesh often = foldedSheet(13, 4, 3);
  EXPECT_EQ(selfIntersections(often), allPairsReference(often));
  SurfaceMesh opened = often;
  for (Index v = 0; v < opened.vertexCount(); ++v)
  {
    opened.points[static_cast<std::size_t>(v)].z() = 1e-3 * (v / 4);
  }
  EXPECT_TRUE(selfIntersections(opened).empty()) << "the folds are opened a little";
}

TEST(SelfIntersections, ABigTriangleThroughASphere)
{
  SurfaceMesh mesh = unitIcosphere(4);
  mesh.points.insert(
    mesh.points.end(), { { -90, -100, 0.01 }, { 110, -80, 0.02 }, { 3, 120, 0.03 } });
  const Index n = mesh.vertexCount();
  mesh.addFace({ n - 3, n - 2, n - 1 });
  const Pairs pairs = selfIntersections(mesh);
  EXPECT_EQ(pairs, allPairsReference(mesh));
  EXPECT_GT(pairs.size(), 60U);
}

TEST(SelfIntersections, WeldingTakesTheTouchingNeighboursAway)
{
  const SurfaceMesh soup = soupOf(unitIcosphere(1));
  EXPECT_EQ(selfIntersections(soup), allPairsReference(soup));
  // 120 edges, and at 12 vertices 5, at 30 vertices 6 triangles, of which 2 or 3 are no neighbours.
  EXPECT_EQ(selfIntersections(soup).size(), 120U + 12U * 5U + 30U * 9U);
  EXPECT_TRUE(selfIntersections(weldCoincidentPoints(soup)).empty());
}

TEST(SelfIntersections, DuplicateFacesCountAndFacesWithoutAreaDoNot)
{
  SurfaceMesh mesh = unitIcosphere(1);
  mesh.addFace({ mesh.faceVertex(7, 1), mesh.faceVertex(7, 0), mesh.faceVertex(7, 2) });
  EXPECT_EQ(selfIntersections(mesh), (Pairs{ { 7, 80 } }));
  mesh.addFace({ 0, 0, 1 });
  mesh.addFace({ 3, 3, 3 });
  EXPECT_EQ(selfIntersections(mesh), (Pairs{ { 7, 80 } }));
}

TEST(SelfIntersections, DoNotDependOnTheNumbering)
{
  std::mt19937 generator(67);
  const SurfaceMesh soup = randomSoup(400, { 0.5, 0.05 }, generator);
  std::vector<Index> order(static_cast<std::size_t>(soup.faceCount()));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), generator);
  SurfaceMesh other;
  other.points = soup.points;
  for (const Index face : order)
  {
    other.addFace({ soup.faceVertex(face, 2), soup.faceVertex(face, 0), soup.faceVertex(face, 1) });
  }
  Pairs pairs;
  for (const auto& pair : selfIntersections(other))
  {
    pairs.push_back(std::minmax({ order[static_cast<std::size_t>(pair.first)],
      order[static_cast<std::size_t>(pair.second)] }));
  }
  std::sort(pairs.begin(), pairs.end());
  EXPECT_EQ(pairs, selfIntersections(soup));
}

TEST(SelfIntersections, DoNotDependOnScaleOrPlace)
{
  std::mt19937 generator(71);
  const SurfaceMesh soup = randomSoup(400, { 0.5, 0.05 }, generator);
  const Pairs expected = selfIntersections(soup);
  EXPECT_GT(expected.size(), 20U);
  for (const int exponent : { -1000, -300, -1, 1, 300, 1000 })
  {
    const SurfaceMesh scaled = transformed(soup, std::ldexp(1.0, exponent), Vec3::Zero());
    EXPECT_EQ(selfIntersections(scaled), expected) << "times 2^" << exponent;
  }
  EXPECT_EQ(selfIntersections(transformed(soup, 1e-30, Vec3::Zero())), expected);
  EXPECT_EQ(selfIntersections(transformed(soup, 1e30, Vec3::Zero())), expected);
  EXPECT_EQ(selfIntersections(transformed(soup, 1.0, { 1e6, -2e6, 3e5 })), expected);
  EXPECT_EQ(selfIntersections(mapped(soup, randomRotation(generator))), expected);
  // Whole numbers: this move is exact, so every touching pair must still touch.
  const SurfaceMesh folded = foldedSheet(13, 4, 3);
  EXPECT_EQ(selfIntersections(transformed(folded, 1.0, { 1e15, -1e15, 12345.0 })),
    selfIntersections(folded));
}

TEST(SelfIntersections, AreTheSameForAnyThreads)
{
  std::mt19937 generator(73);
  const SurfaceMesh soup = randomSoup(3000, { 0.2, 0.02, 0.02 }, generator);
  const Pairs serial = selfIntersections(soup);
  EXPECT_GT(serial.size(), 100U);
  for (const int threads : { 2, 8 })
  {
    EXPECT_EQ(selfIntersections(soup, threadedExecution(threads, 13)), serial);
  }
}

TEST(SelfIntersections, RefuseWhatTheyCannotRead)
{
  EXPECT_THROW(selfIntersections(unitCube()), InputError);
  SurfaceMesh mesh = cornerTetrahedron();
  mesh.points[2].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(selfIntersections(mesh), InputError);
  mesh = cornerTetrahedron();
  mesh.cornerVertices[4] = 17;
  EXPECT_THROW(selfIntersections(mesh), InputError);
}

TEST(SelfIntersections, StopWhenAsked)
{
  const Execution stopping(nullptr, nullptr, [] { return true; });
  EXPECT_THROW(selfIntersections(unitIcosphere(2), stopping), Cancelled);
}

} // namespace

} // namespace evolving
