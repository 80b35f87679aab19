// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/DistanceTarget.h"

#include "Errors.h"
#include "Mesh/TriangleEdges.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

using namespace evolving;
using namespace evolving::shapes;

TEST(DistanceTarget, WeldsASoupAndKeepsFaceNumbers)
{
  SurfaceMesh soup;
  const SurfaceMesh whole = sphere(1);
  soup.addFace({ soup.addPoint(Vec3(0, 0, 0)), soup.addPoint(Vec3(0, 0, 0)),
    soup.addPoint(Vec3(1, 0, 0)) }); // loses an edge by welding
  for (Index face = 0; face < whole.faceCount(); ++face)
  {
    soup.addFace({ soup.addPoint(whole.facePoint(face, 0)), soup.addPoint(whole.facePoint(face, 1)),
      soup.addPoint(whole.facePoint(face, 2)) });
  }
  const DistanceTarget target = makeDistanceTarget(soup);
  EXPECT_EQ(target.mesh.vertexCount(), whole.vertexCount());
  ASSERT_EQ(target.mesh.faceCount(), whole.faceCount());
  EXPECT_EQ(target.oldNumber.front(), 1);
  EXPECT_EQ(target.oldNumber.back(), whole.faceCount());
  EXPECT_TRUE(target.orientation.isClosed());
}

TEST(DistanceTarget, KeepsOneOfDuplicateFaces)
{
  SurfaceMesh twice = merged(sphere(1), sphere(1));
  twice = merged(twice, reversed(sphere(1)));
  const DistanceTarget target = makeDistanceTarget(twice);
  EXPECT_EQ(target.mesh.faceCount(), sphere(1).faceCount());
  EXPECT_TRUE(target.orientation.isClosed());
  EXPECT_GT(signedVolume(target.mesh), 1.0);
}

TEST(DistanceTarget, LiesAtItsCentre)
{
  const Vec3 far(1e7, -2e7, 3e7);
  const DistanceTarget target = makeDistanceTarget(sphere(1, 1.0, far));
  EXPECT_LT((target.center - far).norm(), 1e-6);
  EXPECT_LT(boundingBox(target.mesh).center().norm(), 1e-6);
}

TEST(DistanceTarget, CutsPolygons)
{
  SurfaceMesh mesh;
  mesh.points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0) };
  mesh.addFace({ 0, 1, 2, 3 });
  EXPECT_EQ(makeDistanceTarget(mesh).oldNumber, (std::vector<Index>{ 0, 0 }));
}

TEST(DistanceTarget, OfPointsKeepsTheFirstOfEqualOnes)
{
  SurfaceMesh points;
  points.points = { Vec3(1, 0, 0), Vec3(0, 0, 0), Vec3(1, 0, 0) };
  const DistanceTarget target = makeDistanceTarget(points);
  EXPECT_TRUE(target.isPointSet);
  EXPECT_EQ(target.oldNumber, (std::vector<Index>{ 0, 1 }));
}

TEST(DistanceTarget, RefusesWhatCannotBeMeasuredTo)
{
  EXPECT_THROW(makeDistanceTarget(SurfaceMesh()), InputError);
  EXPECT_THROW(
    makeDistanceTarget(triangleMesh(Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(1, 0, 0))), InputError);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(
    makeDistanceTarget(triangleMesh(Vec3(0, nan, 0), Vec3(0, 1, 0), Vec3(1, 0, 0))), InputError);
  SurfaceMesh damaged = sphere(1);
  damaged.cornerVertices[3] = 1000;
  EXPECT_THROW(makeDistanceTarget(damaged), InputError);
}

TEST(DistanceTarget, HasTheEdgesOfItsTurnedTriangles)
{
  SurfaceMesh mesh = sphere(1);
  for (Index face = 0; face < mesh.faceCount(); face += 3)
  {
    std::swap(mesh.cornerVertices[at(3 * face + 1)], mesh.cornerVertices[at(3 * face + 2)]);
  }
  const DistanceTarget target = makeDistanceTarget(mesh);
  ASSERT_GT(target.orientation.turnedFaces, 0);
  EXPECT_EQ(target.orientation.edgeOfCorner, TriangleEdges(target.mesh).takeEdgeOfCorner());
}
