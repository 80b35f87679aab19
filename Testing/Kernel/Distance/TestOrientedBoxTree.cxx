// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/ClosestPoint/OrientedBoxTree.h"
#include "Errors.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "ThreadedExecution.h"
#include "Trees/OrientedBox.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

constexpr double Margin = 1e-4;

/// By how much a point sticks out of a box of a fan; 0 inside.
double excess(const BoxFan& fan, int box, const Vec3& point)
{
  double largest = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    double local = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      local += (point[axis] - fan.center[axis][box]) * fan.axis[k][axis][box];
    }
    largest = std::max(largest, std::abs(local) - fan.halfSize[k][box]);
  }
  return largest;
}

/// The numbers, in the caller's list, of the triangles below a fan; checks the boxes on the way.
std::vector<Index> checkedTriangles(
  const OrientedBoxTree& tree, const std::vector<Triangle>& triangles, Index number)
{
  const BoxFan& fan = tree.fans()[static_cast<std::size_t>(number)];
  std::vector<Index> all;
  for (int box = 0; box < fan.count; ++box)
  {
    std::vector<Index> inBox;
    if (fan.isLeaf)
    {
      inBox = { tree.triangles()[static_cast<std::size_t>(fan.child[box])].number };
    }
    else
    {
      EXPECT_GT(fan.child[box], number);
      inBox = checkedTriangles(tree, triangles, fan.child[box]);
    }
    for (const Index triangle : inBox)
    {
      for (const Vec3& corner : triangles[static_cast<std::size_t>(triangle)].corners)
      {
        EXPECT_LE(excess(fan, box, corner), 0.0);
      }
    }
    all.insert(all.end(), inBox.begin(), inBox.end());
  }
  return all;
}

} // namespace

TEST(OrientedBoxTree, HasEveryTriangleOnceAndInAllBoxesAboveIt)
{
  const SurfaceMesh shapes[] = { sphere(3), torus(21, 9, 1.0, 0.35), randomSoup(57, 0.5, 3),
    randomSoup(1, 0.5, 3), randomSoup(8, 0.5, 1), randomSoup(9, 0.5, 1), randomSoup(73, 0.5, 1) };
  for (const SurfaceMesh& mesh : shapes)
  {
    const std::vector<Triangle> triangles = trianglesOf(mesh);
    const OrientedBoxTree tree(triangles, Margin);
    std::vector<Index> found = checkedTriangles(tree, triangles, 0);
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found.size(), triangles.size());
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      EXPECT_EQ(found[i], static_cast<Index>(i));
    }
  }
}

TEST(OrientedBoxTree, IsTheSameForAnyNumberOfThreads)
{
  const std::vector<Triangle> triangles = trianglesOf(torus(60, 30, 1.0, 0.35));
  const OrientedBoxTree serial(triangles, Margin);
  for (const int threads : { 2, 8 })
  {
    const OrientedBoxTree other(triangles, Margin, threadedExecution(threads, 7));
    ASSERT_EQ(other.fans().size(), serial.fans().size());
    for (std::size_t n = 0; n < serial.fans().size(); ++n)
    {
      const BoxFan& a = serial.fans()[n];
      const BoxFan& b = other.fans()[n];
      EXPECT_EQ(a.count, b.count);
      EXPECT_EQ(std::memcmp(a.center, b.center, sizeof(a.center)), 0);
      EXPECT_EQ(std::memcmp(a.axis, b.axis, sizeof(a.axis)), 0);
      EXPECT_EQ(std::memcmp(a.child, b.child, sizeof(a.child)), 0);
    }
  }
}

TEST(OrientedBoxTree, OfNothingIsEmpty)
{
  const OrientedBoxTree tree({}, Margin);
  EXPECT_TRUE(tree.fans().empty());
  EXPECT_TRUE(tree.triangles().empty());
}

TEST(OrientedBoxTree, StopsWhenAsked)
{
  const std::vector<Triangle> triangles = trianglesOf(sphere(5));
  int questions = 0;
  const Execution stopping(nullptr, nullptr, [&] { return ++questions > 2; });
  EXPECT_THROW(OrientedBoxTree(triangles, Margin, stopping), Cancelled);
}

TEST(OrientedBox, LiesInThePlaneOfFlatTriangles)
{
  // Two triangles of a slanted square.
  const Vec3 x = Vec3(1, 1, 0).normalized();
  const Vec3 y = Vec3(1, -1, 2).normalized();
  const Triangle a{ { Vec3(0, 0, 0), x, x + y } };
  const Triangle b{ { Vec3(0, 0, 0), x + y, y } };
  const OrientedBox box = orientedBoxAround({ &a, &b });
  EXPECT_NEAR(std::abs(box.axes.col(2).dot(x.cross(y))), 1.0, 1e-12);
  EXPECT_NEAR(box.halfSize.z(), 0.0, 1e-12);
  EXPECT_NEAR((box.center - 0.5 * (x + y)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((box.axes.transpose() * box.axes - Eigen::Matrix3d::Identity()).norm(), 0.0, 1e-12);
}

TEST(OrientedBox, OfOppositeTrianglesSegmentsAndPointsHasAFrame)
{
  const Triangle up{ { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0) } };
  const Triangle down{ { Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(1, 0, 0) } };
  EXPECT_NEAR(orientedBoxAround({ &up, &down }).halfSize.z(), 0.0, 1e-12);
  const Triangle segment{ { Vec3(1, 1, 1), Vec3(2, 3, 4), Vec3(3, 5, 7) } };
  const Vec3 size = orientedBoxAround({ &segment }).halfSize;
  EXPECT_NEAR(size.x(), 0.5 * Vec3(2, 4, 6).norm(), 1e-12);
  EXPECT_NEAR(size.y() + size.z(), 0.0, 1e-12);
  const Triangle point{ { Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(1, 1, 1) } };
  EXPECT_EQ(orientedBoxAround({ &point }).halfSize, Vec3(0, 0, 0));
  EXPECT_EQ(orientedBoxAround({ &point }).center, Vec3(1, 1, 1));
}

TEST(OrientedBox, OfTrianglesSmallerThanSquaresAreExactHasAxesOfUnitLength)
{
  for (const double length : { 1e-150, 1e-160, 3e-162, 1e-170, 1e-310 })
  {
    const Vec3 tip(0.6 * length, 0.8 * length, 0.0);
    const Triangle segment{ { Vec3::Zero(), tip, tip } };
    const Triangle sliver{ { Vec3::Zero(), Vec3(1, 0, 0), tip } };
    for (const Triangle& triangle : { segment, sliver })
    {
      const Eigen::Matrix3d axes = orientedBoxAround({ &triangle }).axes;
      EXPECT_NEAR((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm(), 0.0, 1e-12)
        << length;
    }
  }
}
