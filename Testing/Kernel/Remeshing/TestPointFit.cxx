// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/PointFit.h"

#include "Checks/SurfaceMeasures.h"
#include "Mesh/MeshQuality.h"
#include "Mesh/SelfIntersections.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/Draws.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "ThreadedExecution.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using namespace evolving;
using namespace evolving::editing;

constexpr double Soft = 0.01;

/// Points spread evenly over the unit sphere, where keep(point) holds.
template <typename Keep>
std::vector<Vec3> spherePoints(int count, const Keep& keep)
{
  std::mt19937 generator(17);
  std::normal_distribution<double> normal;
  std::vector<Vec3> points;
  while (static_cast<int>(points.size()) < count)
  {
    const Vec3 p = shapes::drawnVector(normal, generator).normalized();
    if (keep(p))
    {
      points.push_back(p);
    }
  }
  return points;
}

std::vector<Vec3> spherePoints(int count)
{
  return spherePoints(count, [](const Vec3&) { return true; });
}

EditableSurface inflatedSphere(int level)
{
  const SurfaceMesh mesh = shapes::transformed(icosphere(level), 1.05, Vec3(0.02, -0.01, 0.03));
  return shapes::sized(mesh, meanEdgeLength(mesh));
}

TEST(PointFit, ReachesTheSphereOfItsPointsWithSecondOrder)
{
  // What is left is what triangles of edge L cut off when their mean error is zero: 0.032 L^2.
  const std::vector<Vec3> points = spherePoints(20000);
  double last = 0.0;
  for (const int level : { 2, 3 })
  {
    EditableSurface surface = inflatedSphere(level);
    const double unit = std::pow(surface.size(0), 2.0);
    fitToPoints(surface, points, Soft, 6);
    const double rms = checks::rmsDistance(points, surface.mesh());
    EXPECT_LT(rms, 0.036 * unit);
    EXPECT_GT(rms, 0.028 * unit);
    if (last > 0.0)
    {
      EXPECT_NEAR(std::log2(last / rms), 2.0, 0.2);
    }
    last = rms;
  }
}

TEST(PointFit, ReachesAnEllipsoid)
{
  const Vec3 axes(1.0, 1.3, 0.8);
  std::vector<Vec3> points = spherePoints(8000);
  for (Vec3& p : points)
  {
    p = p.cwiseProduct(axes);
  }
  const SurfaceMesh near = shapes::ellipsoid(3, 1.04 * axes);
  EditableSurface surface = shapes::sized(near, meanEdgeLength(near));
  const double before = checks::rmsDistance(points, surface.mesh());
  fitToPoints(surface, points, Soft, 6);
  EXPECT_GT(before, 0.03);
  EXPECT_LT(checks::rmsDistance(points, surface.mesh()), 0.0015);
  EXPECT_TRUE(selfIntersections(surface.mesh()).empty());
}

TEST(PointFit, BridgesAHoleSmoothly)
{
  // No point within 0.6 of the pole. The moves of what lies there follow those around.
  const auto isBelow = [](const Vec3& p) { return p.z() < std::cos(0.6); };
  EditableSurface surface = inflatedSphere(3);
  fitToPoints(surface, spherePoints(10000, isBelow), Soft, 6);
  for (const Index v : verticesOf(surface))
  {
    EXPECT_NEAR(surface.point(v).norm(), 1.0, isBelow(surface.point(v)) ? 0.01 : 0.05);
  }
  // Nowhere does a face stand up.
  for (Index f = 0; f < surface.faceSlots(); ++f)
  {
    const Vec3 middle = surface.corner(f, 0) + surface.corner(f, 1) + surface.corner(f, 2);
    EXPECT_GT(surface.doubleArea(f).normalized().dot(middle.normalized()), std::cos(0.2));
  }
}

TEST(PointFit, AveragesNoise)
{
  // Forty points a vertex would give a mean 6.3 times as good; hat functions, which overlap, about
  // 2.5 times that variance.
  std::vector<Vec3> points = spherePoints(6480);
  std::mt19937 generator(3);
  std::normal_distribution<double> noise(0.0, 0.02);
  for (Vec3& p : points)
  {
    p *= 1.0 + noise(generator);
  }
  EditableSurface surface = inflatedSphere(2);
  EditableSurface clean = surface;
  fitToPoints(surface, points, 0.5, 6);
  fitToPoints(clean, spherePoints(6480), 0.5, 6);
  double squares = 0.0;
  for (const Index v : verticesOf(surface))
  {
    squares += (surface.point(v) - clean.point(v)).squaredNorm();
  }
  EXPECT_LT(std::sqrt(squares / surface.vertexSlots()), 0.02 / 3.6);
}

TEST(PointFit, StiffnessMakesMovesAlike)
{
  // A bump of points that a stiff surface does not follow.
  std::vector<Vec3> points = spherePoints(8000);
  for (Vec3& p : points)
  {
    p *= 1.0 + 0.1 * std::exp(-20.0 * (p - Vec3::UnitZ()).squaredNorm());
  }
  std::vector<double> heights;
  for (const double stiffness : { 0.01, 10.0, 1e4 })
  {
    EditableSurface surface = shapes::sized(icosphere(3), 0.15);
    fitToPoints(surface, points, stiffness, 1);
    heights.push_back(surface.point(shapes::vertexNear(surface, Vec3::UnitZ())).norm() - 1.0);
  }
  EXPECT_GT(heights[0], 0.07);
  EXPECT_LT(heights[1], 0.75 * heights[0]);
  EXPECT_LT(heights[2], 0.1 * heights[0]);
}

TEST(PointFit, OrderOfThePointsIsRoundingOnly)
{
  std::vector<Vec3> points = spherePoints(5000);
  EditableSurface one = inflatedSphere(3);
  EditableSurface other = one;
  fitToPoints(one, points, 0.5, 3);
  std::shuffle(points.begin(), points.end(), std::mt19937(4));
  fitToPoints(other, points, 0.5, 3);
  for (const Index v : verticesOf(one))
  {
    EXPECT_LT((one.point(v) - other.point(v)).norm(), 1e-6);
  }
}

TEST(PointFit, IsTheSameOnAnyThreads)
{
  const std::vector<Vec3> points = spherePoints(5000);
  EditableSurface serial = inflatedSphere(3);
  fitToPoints(serial, points, 0.5, 2);
  for (const int threads : { 2, 4 })
  {
    EditableSurface surface = inflatedSphere(3);
    fitToPoints(surface, points, 0.5, 2, threadedExecution(threads, 8));
    EXPECT_TRUE(surface.mesh() == serial.mesh());
  }
}

TEST(PointFit, NothingToFitChangesNothing)
{
  EditableSurface surface = inflatedSphere(2);
  const SurfaceMesh before = surface.mesh();
  fitToPoints(surface, {}, 0.5, 2);
  EXPECT_TRUE(surface.mesh() == before);
  EditableSurface empty{ SurfaceMesh() };
  fitToPoints(empty, { Vec3::Ones() }, 0.5, 2);
  EXPECT_EQ(empty.faceSlots(), 0);
}

} // namespace
