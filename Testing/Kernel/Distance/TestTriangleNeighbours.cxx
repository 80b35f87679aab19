// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/TriangleNeighbours.h"

#include "DistanceShapes.h"

#include <gtest/gtest.h>

#include <set>

using namespace evolving;
using namespace evolving::test;

TEST(TriangleNeighbours, ShareAVertex)
{
  const SurfaceMesh mesh = torus(1.0, 0.4, 9, 7);
  const TriangleNeighbours neighbours(mesh, AABBTree(mesh));
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    std::set<Index> expected;
    for (Index other = 0; other < mesh.faceCount(); ++other)
    {
      for (Index k = 0; k < 9 && other != face; ++k)
      {
        if (mesh.faceVertex(face, k / 3) == mesh.faceVertex(other, k % 3))
        {
          expected.insert(other);
        }
      }
    }
    const std::vector<Index> found(neighbours.begin(face), neighbours.end(face));
    EXPECT_EQ(found, std::vector<Index>(expected.begin(), expected.end()));
  }
}

TEST(TriangleNeighbours, LeaveLargeFansOut)
{
  constexpr int Count = 2000;
  SurfaceMesh fan;
  fan.addPoint(Vec3(0, 0, 0));
  for (int n = 0; n < Count; ++n)
  {
    fan.addPoint(Vec3(std::cos(2 * Pi * n / Count), std::sin(2 * Pi * n / Count), 0));
  }
  for (Index n = 0; n < Count; ++n)
  {
    fan.addFace({ 0, 1 + n, 1 + (n + 1) % Count });
  }
  const TriangleNeighbours neighbours(fan, AABBTree(fan));
  // Those of the rim's two vertices are two; others come from around it, but not all 2000.
  const Index found = static_cast<Index>(neighbours.end(5) - neighbours.begin(5));
  EXPECT_GE(found, 2);
  EXPECT_LE(found, TriangleNeighbours::LargestFan);
}

TEST(TriangleNeighbours, OfPointsAreThoseAround)
{
  SurfaceMesh points;
  for (int n = 0; n < 900; ++n)
  {
    const Index p = points.addPoint(Vec3(n % 30, n / 30, 0));
    points.addFace({ p, p, p });
  }
  const TriangleNeighbours neighbours(points, AABBTree(points));
  for (int n = 0; n < 900; ++n)
  {
    const std::set<Index> found(neighbours.begin(n), neighbours.end(n));
    EXPECT_EQ(found.count(n), 0U);
    for (const int next : { n % 30 < 29 ? n + 1 : n - 1, n < 870 ? n + 30 : n - 30 })
    {
      EXPECT_EQ(found.count(next), 1U) << n;
    }
    EXPECT_LE(found.size(), 24U);
  }
}
