// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/WindingSign.h"

#include "Distance/ClosestPoint/ClosestOnGrid.h"
#include "Distance/ClosestTriangles.h"
#include "Distance/Signs/WindingNumber.h"
#include "Errors.h"
#include "Mesh/Angles.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

struct NamedShape
{
  std::string name;
  SurfaceMesh mesh;
};

/// A profile turned about z: walls of triangles far longer than wide, open at both ends or not.
SurfaceMesh longSlivers(int around, bool isOpen = false)
{
  const double radius[] = { 0.2, 1.0, 1.0, 0.3 };
  const double height[] = { -1.5, -1.2, 1.1, 1.4 };
  SurfaceMesh mesh;
  for (int k = 0; k < around; ++k)
  {
    const double angle = 2.0 * Pi * k / around;
    for (int ring = 0; ring < 4; ++ring)
    {
      mesh.addPoint(
        Vec3(radius[ring] * std::cos(angle), radius[ring] * std::sin(angle), height[ring]));
    }
  }
  const Index bottom = mesh.addPoint(Vec3(0, 0, height[0]));
  const Index top = mesh.addPoint(Vec3(0, 0, height[3]));
  for (int k = 0; k < around; ++k)
  {
    const Index a = 4 * k;
    const Index b = 4 * ((k + 1) % around);
    for (int ring = 0; ring < 3; ++ring)
    {
      mesh.addFace({ a + ring, b + ring, b + ring + 1 });
      mesh.addFace({ a + ring, b + ring + 1, a + ring + 1 });
    }
    if (!isOpen)
    {
      mesh.addFace({ bottom, b, a });
      mesh.addFace({ top, a + 3, b + 3 });
    }
  }
  return mesh;
}

SurfaceMesh unitBox(double half = 1.0)
{
  return box(Vec3::Constant(-half), Vec3::Constant(half));
}

/// Some of them with planes and edges where samples are, thinner than a cell and beside rows.
std::vector<NamedShape> namedShapes()
{
  const auto everyNinth = [](Index face) { return face % 9 == 0; };
  const auto everyFiftieth = [](Index face) { return face % 50 == 7; };
  std::vector<NamedShape> all{
    { "box", unitBox() },
    { "box in a box", merged(unitBox(), reversed(unitBox(0.5))) },
    { "boxes that overlap", merged(unitBox(0.75), box(Vec3(0, 0, 0), Vec3(1, 1, 1))) },
    { "boxes with a face in common",
      merged(box(Vec3(-1, -1, -1), Vec3(0, 1, 1)), box(Vec3(0, -1, -1), Vec3(1, 1, 1))) },
    { "thin plates",
      merged(
        box(Vec3(-1, -1, 0), Vec3(1, 1, 0.01)), box(Vec3(0, -0.03, -1), Vec3(0.02, 0.03, 1))) },
    { "box with a hole", without(unitBox(), [](Index face) { return face < 2; }) },
    { "bowl", bowl(4, 0.1) },
    { "ball with holes", without(sphere(4), everyFiftieth) },
    { "ball with wrong faces", turned(sphere(3), everyNinth) },
    { "soup", randomSoup(300, 0.5, 3) },
    { "soup of small triangles", randomSoup(1000, 0.05, 4) },
    { "slivers", longSlivers(150) },
    { "slivers between two rims", longSlivers(150, true) },
    { "box without two sides in planes of samples",
      without(unitBox(0.5), [](Index face) { return face < 4; }) },
    { "two boxes that share a side's place, both without it",
      merged(without(box(Vec3(-1, -1, -1), Vec3(0, 1, 1)), [](Index f) { return f > 9; }),
        without(box(Vec3(0, -1, -1), Vec3(1, 1, 1)), [](Index f) { return f == 8; })) },
    { "ball with wrong faces and holes", without(turned(sphere(3), everyNinth), everyFiftieth) },
    { "slivers with holes", without(longSlivers(150), everyFiftieth) },
  };
  // A wedge whose caps lie in planes of samples; its walls stand askew.
  SurfaceMesh wedge;
  for (const double z : { -1.0, 1.0 })
  {
    wedge.addPoint(Vec3(-0.9, -0.17, z));
    wedge.addPoint(Vec3(0.83, 0.04, z));
    wedge.addPoint(Vec3(-0.71, 0.31, z));
  }
  for (const auto& [a, b, c] : { std::array<Index, 3>{ 0, 2, 1 }, { 3, 4, 5 }, { 0, 1, 4 },
         { 0, 4, 3 }, { 1, 2, 5 }, { 1, 5, 4 }, { 2, 0, 3 }, { 2, 3, 5 } })
  {
    wedge.addFace({ a, b, c });
  }
  all.push_back({ "wedge", wedge });
  return all;
}

std::vector<char> insideOf(
  const DistanceTarget& target, const DistanceGrid& grid, const Execution& execution = {})
{
  const GridClosest closest =
    closestOnGrid(target.mesh, grid, std::numeric_limits<double>::infinity());
  return insideByWindingNumber(target, grid, closest.distance, execution);
}

double exactSum(const SurfaceMesh& mesh, const Vec3& point)
{
  double sum = 0.0;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    sum += windingNumber(triangleOf(mesh, face), point);
  }
  return sum;
}

} // namespace

TEST(WindingSign, IsThatOfTheExactSumAtEverySample)
{
  for (const NamedShape& shape : namedShapes())
  {
    const DistanceTarget target = makeDistanceTarget(shape.mesh);
    const Box bounds = boundingBox(target.mesh);
    // Samples in the planes of the boxes, beside them, and a part of the shape only.
    const DistanceGrid grids[] = { gridOver(Box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), { 17, 9, 9 }),
      gridOver(bounds, { 17, 9, 13 }), gridAround(bounds, { 19, 14, 11 }, 0.1),
      gridOver(Box(Vec3(-0.5, -0.25, -0.75), Vec3(0.25, 0.5, 0.5)), { 13, 7, 11 }) };
    for (const DistanceGrid& grid : grids)
    {
      const GridClosest closest =
        closestOnGrid(target.mesh, grid, std::numeric_limits<double>::infinity());
      const std::vector<char> inside = insideByWindingNumber(target, grid, closest.distance);
      forEachSample(grid, Execution(),
        [&](GridIndex sample, const Vec3& point)
        {
          const double winding = exactSum(target.mesh, point);
          const bool isTold = closest.distance[at(sample)] > 1e-9F &&
            std::abs(winding - WindingThreshold) > WindingNumber::Tolerance;
          ASSERT_TRUE(!isTold || (inside[at(sample)] != 0) == (winding > WindingThreshold))
            << shape.name << " at " << point.transpose() << ", winding number " << winding;
        });
    }
  }
}

TEST(WindingSign, IsTheSameForAnyNumberOfThreads)
{
  const DistanceTarget target =
    makeDistanceTarget(without(longSlivers(200), [](Index f) { return f == 3; }));
  const DistanceGrid grid = gridAround(boundingBox(target.mesh), { 30, 37, 21 }, 0.1);
  const std::vector<char> serial = insideOf(target, grid);
  for (const int threads : { 2, 8 })
  {
    EXPECT_EQ(insideOf(target, grid, threadedExecution(threads, 7)), serial);
  }
}

TEST(WindingSign, StopsWhenAsked)
{
  const DistanceTarget target = makeDistanceTarget(sphere(4));
  const DistanceGrid grid = gridAround(boundingBox(target.mesh), { 40, 40, 40 }, 0.1);
  int questions = 0;
  const Execution stopping(nullptr, nullptr, [&] { return ++questions > 6; });
  EXPECT_THROW(insideOf(target, grid, stopping), Cancelled);
}
