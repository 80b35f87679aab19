// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The boxes of an AABBTree hold floats: they must be as tight around a model far from the origin
 * as beside it. The models have sizes that are no numbers of few binary digits, which floats
 * would hold exactly wherever they are.
 */

#include "Checks/AllTriangles.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

const Vec3 Direction(1.0, -0.7, 0.3);

SurfaceMesh moved(SurfaceMesh mesh, const Vec3& shift)
{
  for (Vec3& point : mesh.points)
  {
    point += shift;
  }
  return mesh;
}

std::vector<SurfaceMesh> bodies()
{
  return { sphere(4, 1.03), torus(40, 20, 1.07, 0.31), randomSoup(300, 0.3, 3) };
}

Index largestLeaf(const AABBTree& tree)
{
  Index largest = 0;
  for (const AABBTree::Node& node : tree.nodes())
  {
    largest = std::max(largest, node.triangleCount);
  }
  return largest;
}

Box grown(const Box& box, double margin)
{
  return { Vec3(box.min() - Vec3::Constant(margin)), Vec3(box.max() + Vec3::Constant(margin)) };
}

/// The leaves in which each triangle is.
std::vector<std::vector<Box>> leafBoxes(const AABBTree& tree)
{
  std::vector<std::vector<Box>> boxes(tree.triangles().size());
  for (const AABBTree::Node& node : tree.nodes())
  {
    for (Index k = node.firstTriangle; k < node.firstTriangle + node.triangleCount; ++k)
    {
      boxes[at(tree.leafTriangles()[at(k)])].push_back(node.box);
    }
  }
  return boxes;
}

class Somewhere
{
public:
  Vec3 operator()(double size = 1.5)
  {
    return size *
      Vec3(this->Uniform(this->Random), this->Uniform(this->Random), this->Uniform(this->Random));
  }

private:
  std::mt19937 Random{ 29 };
  std::uniform_real_distribution<double> Uniform{ -1.0, 1.0 };
};

} // namespace

TEST(AABBTreeFarAway, HasNoLargerLeaves)
{
  for (const SurfaceMesh& shape : bodies())
  {
    const AABBTree home(shape);
    for (const double offset : { 1e3, 1e6, 1e7, 1e9, 1e11 })
    {
      const AABBTree tree(moved(shape, offset * Direction));
      // Rounded coordinates break ties between splits in another way.
      EXPECT_LE(largestLeaf(tree), largestLeaf(home) * 5 / 4) << "at " << offset;
      EXPECT_LT(tree.leafTriangles().size(), home.leafTriangles().size() * 101 / 100 + 20)
        << "at " << offset;
    }
  }
}

TEST(AABBTreeFarAway, LeavesAreTight)
{
  for (const SurfaceMesh& shape : bodies())
  {
    for (const double offset : { 0.0, 1e6, 1e7, 1e9 })
    {
      const AABBTree tree(moved(shape, offset * Direction));
      // Far less than a leaf, and some roundings of coordinates.
      const double margin = 1e-5 * tree.bounds().sizes().maxCoeff() + 1e-14 * offset;
      std::size_t loose = 0;
      for (const AABBTree::Node& node : tree.nodes())
      {
        Box inside;
        for (Index k = node.firstTriangle; k < node.firstTriangle + node.triangleCount; ++k)
        {
          inside.extend(tree.triangle(tree.leafTriangles()[at(k)]).box());
        }
        loose += !inside.isEmpty() && !grown(inside, margin).contains(node.box) ? 1 : 0;
      }
      // A few have lost a triangle whose part's box they met, but not the part.
      EXPECT_LT(loose, tree.nodes().size() / 50) << "at " << offset;
    }
  }
}

TEST(AABBTreeFarAway, EveryPointOfATriangleIsInALeafThatHasIt)
{
  Somewhere random;
  for (const SurfaceMesh& shape : bodies())
  {
    for (const double offset : { 0.0, 1e6, 1e7, 1e9, 1e14 })
    {
      const AABBTree tree(moved(shape, offset * Direction));
      const std::vector<std::vector<Box>> boxes = leafBoxes(tree);
      for (Index t = 0; t < tree.triangleCount(); ++t)
      {
        const Triangle& triangle = tree.triangle(t);
        const Vec3 weights = random().cwiseAbs();
        const Vec3 point = (weights.x() * triangle.corners[0] + weights.y() * triangle.corners[1] +
                             weights.z() * triangle.corners[2]) /
          weights.sum();
        const double rounding = 1e-15 * offset;
        for (const Vec3& p :
          { triangle.corners[0], triangle.corners[1], triangle.corners[2], point })
        {
          ASSERT_TRUE(std::any_of(boxes[at(t)].begin(), boxes[at(t)].end(),
            [&](const Box& box) { return grown(box, rounding).contains(p); }))
            << "at " << offset;
        }
      }
    }
  }
}

TEST(AABBTreeFarAway, AnswersAsAllTrianglesDo)
{
  Somewhere random;
  for (const SurfaceMesh& shape : bodies())
  {
    for (const double offset : { 1e6, 1e7, 1e9, 1e14 })
    {
      const Vec3 shift = offset * Direction;
      const AABBTree tree(moved(shape, shift));
      for (int n = 0; n < 100; ++n)
      {
        const Vec3 point = shift + random();
        ASSERT_EQ(tree.closest(point).triangle, checks::closestOfAll(tree, point))
          << "at " << offset;
        const Vec3 half = random(0.1).cwiseAbs();
        const Box query(Vec3(point - half), Vec3(point + half));
        const Ray ray(point, random());
        std::vector<Index> inBox;
        std::set<Index> onRay;
        for (Index t = 0; t < tree.triangleCount(); ++t)
        {
          if (overlaps(tree.triangle(t), query))
          {
            inBox.push_back(t);
          }
          if (ray.hit(tree.triangle(t)))
          {
            onRay.insert(t);
          }
        }
        ASSERT_EQ(tree.trianglesIn(query), inBox) << "at " << offset;
        ASSERT_EQ(tree.meets(query), !inBox.empty()) << "at " << offset;
        std::set<Index> found;
        for (const RayHit& hit : tree.hits(ray))
        {
          found.insert(hit.triangle);
        }
        ASSERT_EQ(found, onRay) << "at " << offset;
      }
    }
  }
}
