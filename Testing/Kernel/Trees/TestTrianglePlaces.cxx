// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Shapes/Draws.h"
#include "Trees/TrianglePlaces.h"

#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace evolving;

namespace
{

std::vector<Vec3> randomPoints(std::size_t count, double size)
{
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-size, size);
  std::vector<Vec3> points(count);
  for (Vec3& point : points)
  {
    point = shapes::drawnVector(uniform, generator);
  }
  return points;
}

Vec3 pointAt(const SurfaceMesh& mesh, const TrianglePlace& place)
{
  Vec3 point = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    point += place.weights[k] * mesh.facePoint(place.triangle, k);
  }
  return point;
}

void expectWeights(const TrianglePlace& place)
{
  EXPECT_GE(place.weights.minCoeff(), 0.0);
  EXPECT_NEAR(place.weights.sum(), 1.0, 1e-12);
}

TEST(TrianglePlaces, AreTheClosestPointsOfAllTriangles)
{
  const SurfaceMesh mesh = icosphere(2);
  const AABBTree tree(mesh);
  const std::vector<Vec3> points = randomPoints(1000, 1.5);
  const auto places = closestPlaces(tree, points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    expectWeights(places[i]);
    double least = std::numeric_limits<double>::infinity();
    for (const Triangle& triangle : trianglesOf(mesh))
    {
      least = std::min(least, closestPointOnTriangle(points[i], triangle).squaredDistance);
    }
    ASSERT_NEAR((pointAt(mesh, places[i]) - points[i]).norm(), std::sqrt(least), 1e-12);
  }
}

TEST(TrianglePlaces, VerticesAreAtACornerAlone)
{
  const SurfaceMesh mesh = icosphere(2);
  const AABBTree tree(mesh);
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    const TrianglePlace place = closestPlace(tree, mesh.points[static_cast<std::size_t>(v)]);
    int corner = 0;
    ASSERT_EQ(place.weights.maxCoeff(&corner), 1.0);
    ASSERT_EQ(mesh.faceVertex(place.triangle, corner), v);
  }
}

TEST(TrianglePlaces, SegmentsAndPointsHavePlacesToo)
{
  SurfaceMesh mesh;
  mesh.points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.25, 0, 0), Vec3(0, 5, 0) };
  mesh.addFace({ 0, 1, 2 });
  mesh.addFace({ 3, 3, 3 });
  const AABBTree tree(mesh);
  const TrianglePlace onSegment = closestPlace(tree, Vec3(0.6, 1, 0));
  expectWeights(onSegment);
  EXPECT_NEAR((pointAt(mesh, onSegment) - Vec3(0.6, 0, 0)).norm(), 0.0, 1e-12);
  const TrianglePlace atPoint = closestPlace(tree, Vec3(0, 9, 0));
  EXPECT_EQ(atPoint.triangle, 1);
  expectWeights(atPoint);
}

} // namespace
