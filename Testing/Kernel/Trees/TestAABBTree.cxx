// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Shapes/Draws.h"
#include "Trees/AABBTree.h"

#include "Checks/AllTriangles.h"
#include "Errors.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"
#include "Trees/TriangleGeometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

struct NamedMesh
{
  const char* name;
  SurfaceMesh mesh;
};

SurfaceMesh pointSet(int count)
{
  std::mt19937 random(17);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  SurfaceMesh mesh;
  for (int n = 0; n < count; ++n)
  {
    const Index p = mesh.addPoint(shapes::drawnVector(uniform, random));
    mesh.addFace({ p, p, p });
  }
  return mesh;
}

const std::vector<NamedMesh>& meshes()
{
  static const std::vector<NamedMesh> all{ { "sphere", sphere(4) },
    { "box", box(Vec3(-1, -1, -1), Vec3(1, 1, 1)) }, { "small soup", randomSoup(600, 0.1, 3) },
    { "large soup", randomSoup(300, 1.0, 5) }, { "points", pointSet(800) },
    { "flat", triangleMesh(Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)) },
    { "same triangle often",
      []
      {
        SurfaceMesh mesh;
        for (int n = 0; n < 50; ++n)
        {
          mesh = merged(mesh, triangleMesh(Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
        }
        return mesh;
      }() } };
  return all;
}

class RandomPoints
{
public:
  Vec3 operator()()
  {
    return { this->Uniform(this->Random), this->Uniform(this->Random),
      this->Uniform(this->Random) };
  }

private:
  std::mt19937 Random{ 23 };
  std::uniform_real_distribution<double> Uniform{ -1.5, 1.5 };
};

} // namespace

TEST(AABBTree, FindsTheClosestOfAllTriangles)
{
  for (const NamedMesh& shape : meshes())
  {
    const AABBTree tree(shape.mesh);
    RandomPoints random;
    for (int n = 0; n < 1000; ++n)
    {
      const Vec3 point = random();
      const Index expected = checks::closestOfAll(tree, point);
      const TrianglePoint at = closestPointOnTriangle(point, tree.triangle(expected));
      const ClosestTriangle found = tree.closest(point);
      ASSERT_EQ(found.triangle, expected) << shape.name;
      ASSERT_EQ(found.at.point, at.point) << shape.name;
      ASSERT_EQ(found.at.feature, at.feature) << shape.name;
    }
  }
}

TEST(AABBTree, TheAnswerDoesNotDependOnBoundOrGuess)
{
  for (const NamedMesh& shape : meshes())
  {
    const AABBTree tree(shape.mesh);
    RandomPoints random;
    for (int n = 0; n < 200; ++n)
    {
      const Vec3 point = random();
      const ClosestTriangle free = tree.closest(point);
      const double squared =
        MeasuredTriangle<double>(tree.triangle(free.triangle)).squaredDistance(point);
      const Index guess = n % tree.triangleCount();
      ASSERT_EQ(tree.closest(point, squared).triangle, free.triangle) << shape.name;
      ASSERT_EQ(tree.closest(point, 2.0 * squared, guess).triangle, free.triangle) << shape.name;
      ASSERT_EQ(tree.closest(point, 0.99 * squared, guess).triangle, NoIndex) << shape.name;
      const Index ofALargerTree = tree.triangleCount() + n;
      ASSERT_EQ(tree.closest(point, squared, ofALargerTree).triangle, free.triangle) << shape.name;
    }
  }
}

TEST(AABBTree, FindsTheTrianglesInABox)
{
  for (const NamedMesh& shape : meshes())
  {
    const AABBTree tree(shape.mesh);
    RandomPoints random;
    for (int n = 0; n < 200; ++n)
    {
      const Vec3 center = random();
      const Vec3 half = 0.2 * random().cwiseAbs();
      const Box query(Vec3(center - half), Vec3(center + half));
      std::vector<Index> expected;
      for (Index t = 0; t < tree.triangleCount(); ++t)
      {
        if (overlaps(tree.triangle(t), query))
        {
          expected.push_back(t);
        }
      }
      ASSERT_EQ(tree.trianglesIn(query), expected) << shape.name;
      ASSERT_EQ(tree.meets(query), !expected.empty()) << shape.name;
    }
  }
}

TEST(AABBTree, FindsAllTrianglesOnARay)
{
  for (const NamedMesh& shape : meshes())
  {
    const AABBTree tree(shape.mesh);
    RandomPoints random;
    for (int n = 0; n < 200; ++n)
    {
      const Ray ray(random(), random());
      std::set<Index> expected;
      for (Index t = 0; t < tree.triangleCount(); ++t)
      {
        if (ray.hit(tree.triangle(t)))
        {
          expected.insert(t);
        }
      }
      std::set<Index> found;
      double last = 0.0;
      for (const RayHit& hit : tree.hits(ray))
      {
        EXPECT_GE(hit.parameter, last);
        last = hit.parameter;
        EXPECT_TRUE(found.insert(hit.triangle).second) << "twice";
      }
      ASSERT_EQ(found, expected) << shape.name;
    }
  }
}

TEST(AABBTree, RayParityTellsInsideFromOutside)
{
  const SurfaceMesh mesh = sphere(3);
  const AABBTree tree(mesh);
  RandomPoints random;
  for (int n = 0; n < 300; ++n)
  {
    const Vec3 point = random();
    if (std::abs(point.norm() - 1.0) > 0.02)
    {
      const Ray ray(point, random());
      EXPECT_EQ(tree.hits(ray).size() % 2 == 1, point.norm() < 1.0);
    }
  }
}

TEST(AABBTree, FollowsTheRulesOfItsConstruction)
{
  const AABBTree tree(sphere(5));
  ASSERT_GT(tree.nodes().size(), 1000U);
  EXPECT_EQ(tree.level(0), 0);
  std::size_t listed = 0;
  for (std::size_t n = 0; n < tree.nodes().size(); ++n)
  {
    const AABBTree::Node& node = tree.nodes()[n];
    EXPECT_LE(tree.level(static_cast<Index>(n)), AABBTree::MaximumDepth);
    if (node.isLeaf())
    {
      listed += static_cast<std::size_t>(node.triangleCount);
      for (Index k = 0; k < node.triangleCount; ++k)
      {
        const auto entry = static_cast<std::size_t>(node.firstTriangle + k);
        EXPECT_TRUE(overlaps(tree.triangle(tree.leafTriangles()[entry]), node.box));
      }
      continue;
    }
    for (const Index child : { node.left, node.right })
    {
      EXPECT_GT(child, static_cast<Index>(n));
      EXPECT_EQ(tree.level(child), tree.level(static_cast<Index>(n)) + 1);
      EXPECT_TRUE(node.box.contains(tree.nodes()[static_cast<std::size_t>(child)].box));
    }
  }
  EXPECT_EQ(listed, tree.leafTriangles().size());
  // Triangles are shared between leaves, but not without end.
  EXPECT_LT(listed, 6U * static_cast<std::size_t>(tree.triangleCount()));
}

TEST(AABBTree, AcceptsNoTriangles)
{
  const AABBTree tree{ SurfaceMesh() };
  EXPECT_TRUE(tree.isEmpty());
  EXPECT_EQ(tree.closest(Vec3(0, 0, 0)).triangle, NoIndex);
  EXPECT_FALSE(tree.meets(Box(Vec3(-1, -1, -1), Vec3(1, 1, 1))));
  EXPECT_TRUE(tree.hits(Ray(Vec3(0, 0, 0), Vec3(1, 0, 0))).empty());
}

TEST(AABBTree, RefusesPolygons)
{
  SurfaceMesh mesh;
  mesh.points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0) };
  mesh.addFace({ 0, 1, 2, 3 });
  EXPECT_THROW(AABBTree{ mesh }, InputError);
}

TEST(AABBTree, StopsWhenAsked)
{
  const Execution stopped(nullptr, nullptr, [] { return true; });
  EXPECT_THROW(AABBTree(sphere(3), stopped), Cancelled);
}
