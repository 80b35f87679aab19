// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/Pseudonormals.h"

#include "Mesh/TriangleEdges.h"
#include "Shapes/Draws.h"
#include "Shapes/Polyhedra.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <random>

using namespace evolving;
using namespace evolving::shapes;

TEST(Pseudonormals, OfABoxPointAwayFromFacesEdgesAndVertices)
{
  const SurfaceMesh mesh = box(Vec3(-1, -1, -1), Vec3(1, 1, 1));
  const std::vector<Index> edges = TriangleEdges(mesh).takeEdgeOfCorner();
  const Pseudonormals normals(mesh, edges);
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto vertex = static_cast<TriangleFeature>(4 + k);
      const Vec3 atVertex = normals.at(face, vertex).normalized();
      EXPECT_LT((atVertex - mesh.facePoint(face, k).normalized()).norm(), 1e-12);
      const auto edge = static_cast<TriangleFeature>(1 + k);
      const Vec3 middle = 0.5 * (mesh.facePoint(face, k) + mesh.facePoint(face, (k + 1) % 3));
      // The middle of a box's edge, or of a face's diagonal.
      EXPECT_LT((normals.at(face, edge).normalized() - middle.normalized()).norm(), 1e-12);
    }
  }
}

TEST(Pseudonormals, TellInsideFromOutsideAtASpike)
{
  // A needle of three long faces: the plain mean of face normals fails at its tip.
  SurfaceMesh mesh;
  mesh.points = { Vec3(0, 0, 10), Vec3(1, 0, 0), Vec3(-0.5, 0.8, 0), Vec3(-0.5, -0.8, 0) };
  mesh.addFace({ 0, 1, 2 });
  mesh.addFace({ 0, 2, 3 });
  mesh.addFace({ 0, 3, 1 });
  mesh.addFace({ 1, 3, 2 });
  ASSERT_GT(signedVolume(mesh), 0.0);
  const AABBTree tree(mesh);
  const std::vector<Index> edges = TriangleEdges(mesh).takeEdgeOfCorner();
  const Pseudonormals normals(mesh, edges);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-3.0, 12.0);
  int inside = 0;
  for (int n = 0; n < 3000; ++n)
  {
    const Vec3 point = n % 2 == 0
      ? shapes::drawnVector(uniform, random)
      : Vec3(0.05 * uniform(random), 0.05 * uniform(random), uniform(random));
    bool expected = true;
    for (Index face = 0; face < 4; ++face)
    {
      expected = expected && faceVectorArea(mesh, face).dot(point - mesh.facePoint(face, 0)) < 0.0;
    }
    const ClosestTriangle closest = tree.closest(point);
    EXPECT_EQ(normals.isInside(point, closest.triangle, closest.at), expected) << point.transpose();
    inside += expected ? 1 : 0;
  }
  EXPECT_GT(inside, 100);
}

TEST(Pseudonormals, IgnoreDegenerateFaces)
{
  // A face without area between two halves of a square.
  SurfaceMesh mesh;
  mesh.points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(1, 1, 0), Vec3(1, -1, 0) };
  mesh.addFace({ 0, 2, 3 });
  mesh.addFace({ 0, 1, 2 });
  mesh.addFace({ 1, 0, 4 });
  mesh.addFace({ 2, 1, 4 });
  const std::vector<Index> edges = TriangleEdges(mesh).takeEdgeOfCorner();
  const Pseudonormals normals(mesh, edges);
  EXPECT_EQ(normals.at(1, TriangleFeature::Face), Vec3(0, 0, 0));
  EXPECT_GT(normals.at(1, TriangleFeature::Edge0).z(), 0.5);
  EXPECT_GT(normals.at(1, TriangleFeature::Vertex1).z(), 0.5);
}
