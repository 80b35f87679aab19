// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Shapes/Draws.h"
#include "Trees/WideBoxTree.h"

#include "Checks/AllTriangles.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Spheres.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

using namespace evolving;
using namespace evolving::shapes;

TEST(BoxRow, GapsAreThoseOfEachBox)
{
  BoxRow row;
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(-1.0F, 1.0F);
  const auto somewhere = [&]
  { return Eigen::Vector3f(uniform(random), uniform(random), uniform(random)); };
  std::vector<FloatBox> boxes(BoxRow::Length - 1); // and a place without one
  for (int k = 0; k < BoxRow::Length - 1; ++k)
  {
    boxes[static_cast<std::size_t>(k)].extend(somewhere()).extend(somewhere());
    row.set(k, boxes[static_cast<std::size_t>(k)]);
  }
  for (int n = 0; n < 100; ++n)
  {
    const Eigen::Vector3f point = 2.0F * somewhere();
    const BoxRow::Lanes gaps = row.squaredGaps(point, 0.0F);
    const BoxRow::Lanes grown = row.squaredGaps(point, 0.1F);
    for (int k = 0; k < BoxRow::Length - 1; ++k)
    {
      const FloatBox& box = boxes[static_cast<std::size_t>(k)];
      EXPECT_NEAR(gaps[k], box.squaredExteriorDistance(point), 1e-5F);
      const Eigen::Vector3f margin = Eigen::Vector3f::Constant(0.1F);
      const FloatBox larger(box.min() - margin, box.max() + margin);
      EXPECT_NEAR(grown[k], larger.squaredExteriorDistance(point), 1e-5F);
    }
    EXPECT_TRUE(std::isinf(gaps[BoxRow::Length - 1]));
  }
}

/// Floats must not lose a triangle, wherever the mesh and the point are.
TEST(WideBoxTree, FindsTheClosestAtAnyScaleAndPlace)
{
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (const double scale : { 1e-30, 1e-10, 1.0, 1e10, 1e30 })
  {
    for (const Vec3& shift :
      { Vec3(0.0, 0.0, 0.0), Vec3(300.0, -200.0, 100.0), Vec3(0.0, 1e7, 0.0) })
    {
      const AABBTree tree(transformed(randomSoup(200, 0.3, 7), scale, scale * shift));
      for (const double distance : { 0.1, 1.0, 100.0, 1e5, 1e9 })
      {
        for (int n = 0; n < 20; ++n)
        {
          const Vec3 way = shapes::drawnVector(normal, random);
          const Vec3 point = scale * (shift + distance * way);
          ASSERT_EQ(tree.closest(point).triangle, checks::closestOfAll(tree, point))
            << "scale " << scale << ", shift " << shift.transpose() << ", distance " << distance;
        }
      }
    }
  }
}

TEST(WideBoxTree, HoldsManyTrianglesInOnePlace)
{
  SurfaceMesh mesh;
  const Index p = mesh.addPoint(Vec3(1.0, 2.0, 3.0));
  for (int n = 0; n < 5000; ++n)
  {
    mesh.addFace({ p, p, p });
  }
  const AABBTree tree(mesh);
  EXPECT_EQ(tree.closest(Vec3(1.0, 2.0, 4.0)).triangle, 0);
  EXPECT_EQ(tree.closest(Vec3(1.0, 2.0, 3.0)).triangle, 0);
}

TEST(WideBoxTree, VisitsFewTriangles)
{
  const SurfaceMesh mesh = sphere(5);
  const AABBTree tree(mesh);
  // The tree's own leaves serve as things to visit; the closest is known beforehand.
  const RootFrame frame(tree.bounds());
  std::vector<FloatBox> boxes;
  for (const Index t : tree.leafTriangles())
  {
    boxes.push_back(roundedOutwards(frame.local(tree.triangle(t).box())));
  }
  const WideBoxTree wide(tree.nodes(), tree.leafTriangles(), boxes, frame);
  int visits = 0;
  for (Index f = 0; f < mesh.faceCount(); ++f)
  {
    const Vec3 middle = tree.triangle(f).box().center();
    const double bound = tree.closest(middle).at.squaredDistance;
    bool isFound = false;
    wide.visitNear(middle, bound,
      [&](Index t)
      {
        ++visits;
        isFound = isFound || t == f;
        return bound;
      });
    EXPECT_TRUE(isFound);
  }
  EXPECT_LT(visits, 10 * mesh.faceCount());
}

TEST(WideBoxTree, WithoutNodesVisitsNothing)
{
  WideBoxTree().visitNear(Vec3::Zero(), 1.0,
    [](Index) -> double
    {
      ADD_FAILURE();
      return 0.0;
    });
}

} // namespace
