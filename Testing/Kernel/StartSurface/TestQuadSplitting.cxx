// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/QuadSplitting.h"

#include "Mesh/MeshQuality.h"

#include <gtest/gtest.h>

#include <random>

using namespace evolving;

namespace
{

SurfaceMesh quadMesh(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  SurfaceMesh mesh;
  mesh.points = { a, b, c, d };
  mesh.addFace({ 0, 1, 2, 3 });
  return mesh;
}

} // namespace

TEST(QuadSplitting, TakesTheDiagonalWithTheLargerSmallestAngle)
{
  std::mt19937 random(7);
  const auto jitter = [&] { return 0.6 * static_cast<double>(random()) / 4294967296.0; };
  int turned = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    const SurfaceMesh quad =
      quadMesh(Vec3(jitter(), jitter(), jitter()), Vec3(1.0 + jitter(), jitter(), jitter()),
        Vec3(1.0 + jitter(), 1.0 + jitter(), jitter()), Vec3(jitter(), 1.0 + jitter(), jitter()));
    SurfaceMesh first = quad;
    first.faceOffsets = { 0, 3, 6 };
    first.cornerVertices = { 0, 1, 2, 0, 2, 3 };
    SurfaceMesh second = first;
    second.cornerVertices = { 1, 2, 3, 1, 3, 0 };
    const SurfaceMesh split = splitQuads(quad);
    ASSERT_EQ(split.faceCount(), 2);
    EXPECT_NEAR(smallestAngle(split), std::max(smallestAngle(first), smallestAngle(second)), 1e-3);
    turned += split.cornerVertices == second.cornerVertices ? 1 : 0;
  }
  EXPECT_GT(turned, 20);
  EXPECT_LT(turned, 180);
}

TEST(QuadSplitting, ASquareIsSplitFromItsFirstCorner)
{
  const SurfaceMesh split =
    splitQuads(quadMesh(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)));
  EXPECT_EQ(split.cornerVertices, (std::vector<Index>{ 0, 1, 2, 0, 2, 3 }));
}

TEST(QuadSplitting, OtherFacesAndAllPointsAreKept)
{
  SurfaceMesh mesh = quadMesh(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0));
  mesh.addPoint(Vec3(0.5, 2.0, 0.0));
  mesh.addFace({ 3, 2, 4 });
  mesh.addFace({ 0, 1, 2, 4, 3 });
  const SurfaceMesh split = splitQuads(mesh);
  EXPECT_EQ(split.points, mesh.points);
  ASSERT_EQ(split.faceCount(), 4);
  EXPECT_EQ(split.faceSize(2), 3);
  EXPECT_EQ(split.faceSize(3), 5);
  EXPECT_EQ(split.faceVertex(3, 3), 4);
}
