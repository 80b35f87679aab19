// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/FeatureCurves.h"
#include "Mesh/Angles.h"
#include "Shapes/CreasedShapes.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

struct Traced
{
  explicit Traced(const SurfaceMesh& mesh, double angle = 45.0, bool withBoundary = false)
    : target(mesh)
    , sharp(this->target, angle, withBoundary)
    , network(this->target, this->sharp)
  {
  }
  TargetTriangles target;
  SharpEdges sharp;
  FeatureCurves network;
};

} // namespace

TEST(FeatureCurves, OfABoxAreItsEdges)
{
  const Traced box123(box(Vec3(0, 0, 0), Vec3(1, 2, 3)));
  ASSERT_EQ(box123.network.curves().size(), 12u);
  EXPECT_EQ(box123.network.corners().size(), 8u);
  double length = 0.0;
  for (const FeatureCurve& curve : box123.network.curves())
  {
    EXPECT_FALSE(curve.isClosed);
    EXPECT_NEAR(curve.fold, 90.0, 1e-10);
    length += curve.length;
  }
  EXPECT_NEAR(length, 24.0, 1e-12);
}

TEST(FeatureCurves, OfACylinderAreTwoClosedOnes)
{
  const Traced cylinder(extruded(regularPolygon(32), 1.0));
  ASSERT_EQ(cylinder.network.curves().size(), 2u);
  EXPECT_TRUE(cylinder.network.corners().empty());
  for (const FeatureCurve& curve : cylinder.network.curves())
  {
    EXPECT_TRUE(curve.isClosed);
    EXPECT_EQ(curve.edges.size(), 32u);
    EXPECT_EQ(curve.vertices.front(), curve.vertices.back());
    EXPECT_NEAR(curve.length, 64.0 * std::sin(Pi / 32.0), 1e-12);
  }
}

TEST(FeatureCurves, TurnAtCornersOfTwoEdges)
{
  // The boundary of a square sheet has corners of two edges each; a hexagon's is closed.
  const Traced square(heightField(4, [](double, double) { return 0.0; }), 45.0, true);
  EXPECT_EQ(square.network.curves().size(), 4u);
  EXPECT_EQ(square.network.corners().size(), 4u);
  SurfaceMesh hexagon;
  hexagon.points = regularPolygon(6);
  hexagon.addFace({ 0, 1, 2, 3, 4, 5 });
  const Traced round(hexagon, 45.0, true);
  ASSERT_EQ(round.network.curves().size(), 1u);
  EXPECT_TRUE(round.network.curves().front().isClosed);
}

TEST(FeatureCurves, EndAtLooseEnds)
{
  // The fold 2 atan((1 - x) / 2) exceeds 60 degrees for x < -0.155: of edges of 0.1 up to -0.2.
  const Traced ridge(fadingRidge(20), 60.0);
  ASSERT_EQ(ridge.network.curves().size(), 1u);
  EXPECT_EQ(ridge.network.curves().front().edges.size(), 8u);
  ASSERT_EQ(ridge.network.corners().size(), 2u);
  const Index end = ridge.network.corners().back();
  EXPECT_EQ(ridge.network.valence(end), 1);
  EXPECT_NEAR(ridge.target.point(end).x(), -0.2, 1e-12);
}

TEST(FeatureCurves, HoldEverySharpEdgeOnce)
{
  std::mt19937 generator(7);
  for (int trial = 0; trial < 30; ++trial)
  {
    const Traced prism(extruded(randomPolygon(generator), 1.0), 30.0);
    std::vector<Index> edges;
    for (const FeatureCurve& curve : prism.network.curves())
    {
      ASSERT_EQ(curve.vertices.size(), curve.edges.size() + 1);
      edges.insert(edges.end(), curve.edges.begin(), curve.edges.end());
    }
    std::sort(edges.begin(), edges.end());
    EXPECT_EQ(edges, prism.sharp.list());
    const auto valences = std::accumulate(prism.network.corners().begin(),
      prism.network.corners().end(), std::size_t{ 0 },
      [&](std::size_t sum, Index c)
      { return sum + static_cast<std::size_t>(prism.network.valence(c)); });
    const auto open = std::count_if(prism.network.curves().begin(), prism.network.curves().end(),
      [](const FeatureCurve& curve) { return !curve.isClosed; });
    EXPECT_EQ(valences, 2 * static_cast<std::size_t>(open));
  }
}
