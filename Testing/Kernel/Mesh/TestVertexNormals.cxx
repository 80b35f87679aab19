// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/VertexNormals.h"

#include "Mesh/MeshTopology.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace evolving
{

using namespace evolving::shapes;

namespace
{

std::vector<Vec3> topologicalNormals(const SurfaceMesh& mesh)
{
  return angleWeightedNormals(mesh, MeshTopology(mesh));
}

void expectNear(const std::vector<Vec3>& found, const std::vector<Vec3>& expected, double tolerance)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_LE((found[i] - expected[i]).norm(), tolerance) << "at vertex " << i;
  }
}

TEST(VertexNormals, CubeCornersLookAlongTheDiagonalHoweverItIsCut)
{
  const SurfaceMesh cube = unitCube();
  std::vector<Vec3> expected;
  for (const Vec3& point : cube.points)
  {
    expected.push_back((point - Vec3::Constant(0.5)).normalized());
  }
  expectNear(topologicalNormals(cube), expected, 1e-15);
  std::mt19937 generator(2);
  for (int trial = 0; trial < 20; ++trial)
  {
    expectNear(topologicalNormals(triangulated(cube, generator)), expected, 1e-15);
  }
}

TEST(VertexNormals, DoNotDependOnHowFlatPartsAreCut)
{
  // An L-shaped prism: concave hexagons at both ends, or six squares.
  const std::vector<Vec3> outline{ { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 },
    { 0, 2, 0 } };
  SurfaceMesh prism = makeMesh(outline, { { 5, 4, 3, 2, 1, 0 }, { 6, 7, 8, 9, 10, 11 } });
  SurfaceMesh cut =
    makeMesh(outline, { { 3, 2, 1, 0 }, { 5, 4, 3, 0 }, { 6, 7, 8, 9 }, { 6, 9, 10, 11 } });
  for (SurfaceMesh* mesh : { &prism, &cut })
  {
    for (Index i = 0; i < 6; ++i)
    {
      mesh->addPoint(outline[static_cast<std::size_t>(i)] + Vec3::UnitZ());
      mesh->addFace({ i, (i + 1) % 6, 6 + (i + 1) % 6, 6 + i });
    }
  }
  expectNear(topologicalNormals(prism), topologicalNormals(cut), 1e-15);
  // At the concave corner the two walls count 90 degrees each, the floor 270.
  EXPECT_LE((topologicalNormals(prism)[3] - Vec3(1, 1, -3).normalized()).norm(), 1e-15);
}

TEST(VertexNormals, AVertexInAStraightEdgeCountsHalfATurnOnBothSides)
{
  SurfaceMesh roof = makeMesh(
    { { 0, 0, 1 }, { 1, 0, 1 }, { 2, 0, 1 }, { 2, -1, 0 }, { 0, -1, 0 }, { 2, 1, 0 }, { 0, 1, 0 } },
    { { 4, 3, 2, 1, 0 }, { 0, 1, 2, 5, 6 } });
  EXPECT_LE((topologicalNormals(roof)[1] - Vec3::UnitZ()).norm(), 1e-15);
}

TEST(VertexNormals, OfASphereConverge)
{
  double last = 0.0;
  for (int level = 2; level <= 4; ++level)
  {
    const SurfaceMesh sphere = unitIcosphere(level);
    const std::vector<Vec3> normals = topologicalNormals(sphere);
    double worst = 0.0;
    for (std::size_t v = 0; v < normals.size(); ++v)
    {
      EXPECT_NEAR(normals[v].norm(), 1.0, 1e-15);
      worst = std::max(worst, (normals[v] - sphere.points[v]).norm());
    }
    if (last > 0.0)
    {
      EXPECT_GT(last / worst, 1.9) << "first order in the edge length";
    }
    last = worst;
  }
  EXPECT_LT(last, 3e-3);
}

TEST(VertexNormals, TurnWithTheMeshAndIgnoreScaleAndPlace)
{
  std::mt19937 generator(7);
  const SurfaceMesh shape = quadTorus(9, 6, 2.0, 0.7);
  const Eigen::Matrix3d rotation = randomRotation(generator);
  std::vector<Vec3> expected = topologicalNormals(shape);
  for (Vec3& normal : expected)
  {
    normal = rotation * normal;
  }
  const SurfaceMesh turned = mapped(shape, rotation);
  expectNear(topologicalNormals(turned), expected, 1e-14);
  expectNear(topologicalNormals(transformed(turned, 1e-30, Vec3::Zero())), expected, 1e-14);
  expectNear(topologicalNormals(transformed(turned, 1e30, Vec3::Zero())), expected, 1e-14);
  expectNear(topologicalNormals(transformed(turned, 1.0, { 1e6, 0, 0 })), expected, 1e-8);
}

TEST(VertexNormals, FlipWithTheFaces)
{
  const SurfaceMesh shape = unitIcosphere(1);
  std::vector<Vec3> expected = topologicalNormals(shape);
  for (Vec3& normal : expected)
  {
    normal = -normal;
  }
  expectNear(topologicalNormals(reversed(shape)), expected, 1e-15);
}

TEST(VertexNormals, WithAndWithoutTopologyAgree)
{
  std::mt19937 generator(9);
  for (const SurfaceMesh& mesh : { unitIcosphere(2), quadTorus(9, 6, 2.0, 0.7), annulus(5),
         triangulated(slabWithHoles(2), generator) })
  {
    expectNear(angleWeightedNormals(mesh), topologicalNormals(mesh), 1e-14);
  }
}

TEST(VertexNormals, AreZeroWithoutAreaAndNeverNaN)
{
  EXPECT_TRUE(angleWeightedNormals(SurfaceMesh()).empty());
  EXPECT_TRUE(topologicalNormals(SurfaceMesh()).empty());
  // A needle, a face of one point, an unused vertex.
  const SurfaceMesh flat = makeMesh(
    { { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 }, { 3, 0, 0 }, { 3, 0, 0 }, { 3, 0, 0 }, { 7, 7, 7 } },
    { { 0, 1, 2 }, { 3, 4, 5 } });
  for (const std::vector<Vec3>& normals : { angleWeightedNormals(flat), topologicalNormals(flat) })
  {
    for (const Vec3& normal : normals)
    {
      EXPECT_EQ(normal, Vec3::Zero());
    }
  }
}

TEST(VertexNormals, ANeedleDoesNotTurnItsNeighbours)
{
  // A plane whose vertex 0 also belongs to an upright triangle of width 1e-17.
  SurfaceMesh mesh = fan(6);
  mesh.addPoint({ 0, 0, 1 });
  mesh.addPoint({ 1e-17, 0, 1 });
  mesh.addFace({ 0, 7, 8 });
  EXPECT_LE((angleWeightedNormals(mesh)[0] - Vec3::UnitZ()).norm(), 1e-15);
}

TEST(VertexNormals, HaveTheSameBitsForAnyThreads)
{
  const SurfaceMesh sphere = unitIcosphere(5);
  const MeshTopology topology(sphere);
  const std::vector<Vec3> serial = angleWeightedNormals(sphere, topology);
  for (const int threads : { 2, 8 })
  {
    EXPECT_EQ(angleWeightedNormals(sphere, topology, threadedExecution(threads, 5)), serial);
  }
}

} // namespace

} // namespace evolving
