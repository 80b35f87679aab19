// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/CurvedReference.h"
#include "Remeshing/ReferenceSurface.h"
#include "Remeshing/Remeshing.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/Draws.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using namespace evolving;

Vec3 randomDirection(std::mt19937& generator)
{
  std::normal_distribution<double> normal;
  return shapes::drawnVector(normal, generator).normalized();
}

/// The root mean square distance of feet on an icosphere from the unit sphere.
double sphereError(const ReferenceSurface& reference)
{
  std::mt19937 generator(7);
  double squares = 0.0;
  for (int i = 0; i < 2000; ++i)
  {
    const Vec3 direction = randomDirection(generator);
    const Vec3 foot = reference.onSurface(direction, direction, 0, NoIndex).point;
    squares += (foot.norm() - 1.0) * (foot.norm() - 1.0);
  }
  return std::sqrt(squares / 2000.0);
}

TEST(OffsetReference, IsAtItsDistanceOnTheSideAskedFor)
{
  const SurfaceMesh mesh = icosphere(3);
  const AABBTree tree(mesh);
  const OffsetReference reference(mesh, 0.1);
  std::mt19937 generator(1);
  for (int i = 0; i < 500; ++i)
  {
    const Vec3 direction = randomDirection(generator);
    for (const double radius : { 0.6, 0.97, 1.02, 1.1, 1.5 })
    {
      const auto foot = reference.onSurface(radius * direction, direction, 0, NoIndex);
      EXPECT_NEAR(std::sqrt(tree.closest(foot.point).at.squaredDistance), 0.1, 1e-3);
      EXPECT_NEAR(foot.normal.norm(), 1.0, 1e-14);
      EXPECT_EQ(foot.point.norm() < 1.0, radius < 1.0);
    }
  }
}

TEST(OffsetReference, IsExactOverAFace)
{
  const OffsetReference reference(shapes::triangleBox(3, Vec3(1.0, 1.0, 1.0)), 0.25);
  for (const double z : { 0.9, 0.999, 1.0, 1.001, 1.1, 2.0 })
  {
    const Vec3 facing = z < 0.95 ? Vec3(-Vec3::UnitZ()) : Vec3(Vec3::UnitZ());
    const auto foot = reference.onSurface(Vec3(0.3, -0.2, z), facing, 0, NoIndex);
    EXPECT_LT((foot.point - Vec3(0.3, -0.2, z < 0.95 ? 0.75 : 1.25)).norm(), 1e-15);
    EXPECT_LT((foot.normal - facing).norm(), 1e-15);
  }
}

TEST(OffsetReference, WithoutOffsetIsTheMeshFacingAsAsked)
{
  const SurfaceMesh mesh = icosphere(2);
  const AABBTree tree(mesh);
  const OffsetReference reference(mesh, 0.0);
  std::mt19937 generator(2);
  for (int i = 0; i < 200; ++i)
  {
    const Vec3 point = 1.3 * randomDirection(generator);
    const ClosestTriangle closest = tree.closest(point);
    for (const double side : { 1.0, -1.0 })
    {
      const auto foot = reference.onSurface(point, side * point.normalized(), 0, NoIndex);
      EXPECT_EQ(foot.point, closest.at.point);
      EXPECT_EQ(foot.triangle, closest.triangle);
      EXPECT_GT(side * foot.normal.dot(point), 0.0);
    }
  }
}

TEST(ReferenceSurface, KnowsNoCurves)
{
  const OffsetReference reference(icosphere(0), 0.0);
  EXPECT_EQ(reference.onCurve(Vec3(1.0, 2.0, 3.0), 0), Vec3(1.0, 2.0, 3.0));
}

TEST(CurvedReference, ErrorOnASphereIsOfFourthOrder)
{
  double lastFlat = 0.0;
  double lastCurved = 0.0;
  for (const int level : { 2, 3, 4 })
  {
    const double flat = sphereError(OffsetReference(icosphere(level), 0.0));
    const double curved = sphereError(CurvedReference(icosphere(level)));
    EXPECT_LT(curved, flat / 40.0);
    if (level > 2)
    {
      EXPECT_NEAR(std::log2(lastFlat / flat), 2.0, 0.05);
      EXPECT_NEAR(std::log2(lastCurved / curved), 4.0, 0.1);
    }
    lastFlat = flat;
    lastCurved = curved;
  }
}

TEST(CurvedReference, ErrorOnAnEllipsoidFallsFasterThanThatOfTriangles)
{
  // Uneven triangles on another surface: the distance to it, to first order, by its equation.
  const Vec3 axes(1.0, 1.5, 2.0);
  const auto error = [&](int level, bool isCurved)
  {
    SurfaceMesh mesh = shapes::shakenSphere(level, 0.15, 6);
    for (Vec3& p : mesh.points)
    {
      p = p.cwiseProduct(axes);
    }
    const CurvedReference curved(mesh);
    const OffsetReference flat(mesh, 0.0);
    std::mt19937 generator(8);
    double squares = 0.0;
    for (int i = 0; i < 2000; ++i)
    {
      const Vec3 point = randomDirection(generator).cwiseProduct(axes);
      const auto foot = isCurved ? curved.onSurface(point, point, 0, NoIndex)
                                 : flat.onSurface(point, point, 0, NoIndex);
      const Vec3 scaled = foot.point.cwiseQuotient(axes);
      const double distance =
        (scaled.squaredNorm() - 1.0) / (2.0 * scaled.cwiseQuotient(axes).norm());
      squares += distance * distance;
    }
    return std::sqrt(squares / 2000.0);
  };
  EXPECT_NEAR(std::log2(error(3, false) / error(4, false)), 2.0, 0.1);
  EXPECT_GT(std::log2(error(3, true) / error(4, true)), 2.3);
  EXPECT_LT(error(4, true), error(4, false) / 40.0);
}

TEST(CurvedReference, LeavesTheVerticesWhereTheyAre)
{
  const SurfaceMesh mesh = shapes::bumpySphere(3);
  const CurvedReference reference(mesh);
  for (const Vec3& p : mesh.points)
  {
    EXPECT_LT((reference.onSurface(p, p, 0, NoIndex).point - p).norm(), 1e-14);
  }
}

TEST(CurvedReference, HasNoGapsAtEdges)
{
  // Seen from both sides of an edge the surface is the same.
  const SurfaceMesh mesh = shapes::bumpySphere(2);
  const CurvedReference reference(mesh);
  for (Index f = 0; f < mesh.faceCount(); ++f)
  {
    const Vec3 a = mesh.facePoint(f, 0);
    const Vec3 b = mesh.facePoint(f, 1);
    const Vec3 c = mesh.facePoint(f, 2);
    const Vec3 inward = 1e-9 * (c - a);
    const Vec3 on = 0.3 * a + 0.7 * b;
    const Vec3 one = reference.onSurface(on + inward, on, 0, NoIndex).point;
    const Vec3 other = reference.onSurface(on - inward, on, 0, NoIndex).point;
    EXPECT_LT((one - other).norm(), 1e-8);
  }
}

TEST(CurvedReference, FollowsTheGuessToTheSameFoot)
{
  const CurvedReference reference(shapes::bumpySphere(3));
  std::mt19937 generator(3);
  for (Index guess = 0; guess < 1280; guess += 13)
  {
    const Vec3 point = 1.2 * randomDirection(generator);
    const auto foot = reference.onSurface(point, point, 0, guess);
    const auto same = reference.onSurface(point, point, 0, NoIndex);
    EXPECT_EQ(foot.point, same.point);
    EXPECT_EQ(foot.triangle, same.triangle);
  }
}

TEST(CurvedReference, SidesOfABoxAreFlat)
{
  // Beside a crease as well: the normals there lie between those of the sides.
  const CurvedReference reference(shapes::triangleBox(6, Vec3(1.0, 1.0, 1.0)));
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int i = 0; i < 500; ++i)
  {
    const Vec3 point(any(generator), any(generator), 1.3);
    const Vec3 foot = reference.onSurface(point, Vec3::UnitZ(), 0, NoIndex).point;
    EXPECT_LT((foot - Vec3(point.x(), point.y(), 1.0)).norm(), 1e-14);
  }
}

/// What becomes of a surface that is remeshed on itself again and again.
template <class Reference>
SurfaceMesh remeshedOnItself(SurfaceMesh mesh, int times, double size)
{
  for (int i = 0; i < times; ++i)
  {
    EditableSurface surface = shapes::sized(mesh, size);
    remeshOnce(surface, Reference(mesh), {});
    mesh = surface.mesh();
  }
  return mesh;
}

struct Flat : OffsetReference
{
  explicit Flat(const SurfaceMesh& mesh)
    : OffsetReference(mesh, 0.0)
  {
  }
};

TEST(CurvedReference, ASphereRemeshedOnItselfDoesNotShrink)
{
  const SurfaceMesh sphere = shapes::shakenSphere(3, 0.1, 5);
  const double volume = signedVolume(sphere);
  const SurfaceMesh curved = remeshedOnItself<CurvedReference>(sphere, 20, 0.15);
  const SurfaceMesh flat = remeshedOnItself<Flat>(sphere, 20, 0.15);
  EXPECT_NEAR(signedVolume(curved), volume, 1e-3 * volume);
  EXPECT_LT(signedVolume(flat), 0.997 * volume);
  double farthest = 0.0;
  for (const Vec3& p : curved.points)
  {
    farthest = std::max(farthest, std::abs(p.norm() - 1.0));
  }
  EXPECT_LT(farthest, 1e-4);
}

} // namespace
