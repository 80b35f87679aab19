// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Shapes/Draws.h"
#include "Trees/NeedleTree.h"

#include "Checks/AllTriangles.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Tubes.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace
{

using namespace evolving;
using namespace evolving::shapes;

constexpr Index Around = 1500;

/// Two rows of needles around an axis that is none of the coordinates'.
SurfaceMesh cones()
{
  Eigen::Matrix3d turn;
  turn = Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -0.5).normalized());
  SurfaceMesh mesh = tube(Around, 3, 1.0, [](double z) { return 0.6 + 0.4 * z * z; });
  for (Vec3& point : mesh.points)
  {
    point = turn * point;
  }
  return mesh;
}

/// In all directions, through each other.
SurfaceMesh strewnNeedles(int count)
{
  std::mt19937 random(31);
  std::normal_distribution<double> normal;
  const auto somewhere = [&] { return shapes::drawnVector(normal, random); };
  SurfaceMesh mesh;
  for (int n = 0; n < count; ++n)
  {
    const Vec3 from = 0.3 * somewhere();
    const Vec3 to = from + somewhere();
    const Index first = mesh.addPoint(from);
    mesh.addPoint(to);
    mesh.addPoint(to + 1e-3 * somewhere());
    mesh.addFace({ first, first + 1, first + 2 });
  }
  return mesh;
}

std::vector<Index> all(const AABBTree& tree)
{
  std::vector<Index> numbers(at(tree.triangleCount()));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

struct Nearest
{
  Index triangle = NoIndex;
  double squared = std::numeric_limits<double>::infinity();
  int visits = 0;
};

Nearest nearestOf(const NeedleTree& needles, const AABBTree& tree, const Vec3& point)
{
  Nearest nearest;
  needles.visitNear(point, nearest.squared,
    [&](Index t)
    {
      ++nearest.visits;
      const double squared = MeasuredTriangle<double>(tree.triangle(t)).squaredDistance(point);
      if (squared < nearest.squared || (squared == nearest.squared && t < nearest.triangle))
      {
        nearest.squared = squared;
        nearest.triangle = t;
      }
      return nearest.squared;
    });
  return nearest;
}

} // namespace

TEST(NeedleTree, FindsTheClosestAtAnyScaleAndPlace)
{
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (const SurfaceMesh& mesh : { cones(), strewnNeedles(400) })
  {
    for (const double scale : { 1e-30, 1.0, 1e30 })
    {
      for (const Vec3& shift : { Vec3(0.0, 0.0, 0.0), Vec3(0.0, 1e7, -300.0) })
      {
        const AABBTree tree(transformed(mesh, scale, scale * shift));
        const NeedleTree needles(tree.triangles(), all(tree));
        for (const double distance : { 1e-6, 0.1, 1.0, 1e5 })
        {
          for (int n = 0; n < 10; ++n)
          {
            const Vec3 way = shapes::drawnVector(normal, random);
            const Triangle& near = tree.triangle((n * 37) % tree.triangleCount());
            const Vec3 point = near.centroid() + scale * distance * way;
            const Index expected = checks::closestOfAll(tree, point);
            ASSERT_EQ(nearestOf(needles, tree, point).triangle, expected)
              << "scale " << scale << ", shift " << shift.transpose() << ", distance " << distance;
            ASSERT_EQ(tree.closest(point).triangle, expected);
          }
        }
      }
    }
  }
}

TEST(NeedleTree, VisitsFewNeedlesSideBySide)
{
  const AABBTree tree(cones());
  const NeedleTree needles(tree.triangles(), all(tree));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-0.05, 0.05);
  int visits = 0;
  constexpr int Points = 500;
  for (int n = 0; n < Points; ++n)
  {
    const Vec3 beside = shapes::drawnVector(uniform, random);
    const Triangle& near = tree.triangle((n * 11) % tree.triangleCount());
    visits += nearestOf(needles, tree, near.centroid() + beside).visits;
  }
  EXPECT_LT(visits, 40 * Points); // of 6000
}

TEST(NeedleTree, HasOnlyTheChosen)
{
  const AABBTree tree(strewnNeedles(50));
  const NeedleTree needles(tree.triangles(), { 3, 20, 41 });
  std::vector<Index> visited;
  needles.visitNear(Vec3::Zero(), std::numeric_limits<double>::infinity(),
    [&](Index t)
    {
      visited.push_back(t);
      return std::numeric_limits<double>::infinity();
    });
  std::sort(visited.begin(), visited.end());
  EXPECT_EQ(visited, (std::vector<Index>{ 3, 20, 41 }));
}

TEST(NeedleTree, WithoutTrianglesVisitsNothing)
{
  NeedleTree({}, {}).visitNear(Vec3::Zero(), 1.0,
    [](Index) -> double
    {
      ADD_FAILURE();
      return 0.0;
    });
}
