// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/UnreachedTarget.h"

#include "Evolution/EvolutionFields.h"
#include "Evolution/FlowRuns.h"
#include "Evolution/SurfaceRemesher.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;

namespace
{

/// From a ring about the z axis of radius 1, whose tube has a radius.
std::shared_ptr<const ScalarImage> ringField(double tube)
{
  return shapes::image(shapes::cubicGrid(61, 1.6),
    [=](const Vec3& p) { return Vec3(p.head<2>().norm() - 1.0, p.z(), 0.0).norm() - tube; });
}

std::shared_ptr<const ScalarImage> twoBalls()
{
  return shapes::image(shapes::cubicGrid(61, 1.6),
    [](const Vec3& p)
    { return std::min((p - Vec3(0.8, 0, 0)).norm(), (p + Vec3(0.8, 0, 0)).norm()) - 0.4; });
}

/// A ball with a ball of air in it.
std::shared_ptr<const ScalarImage> hollowBall()
{
  return shapes::image(shapes::cubicGrid(61, 1.6),
    [](const Vec3& p) { return std::max(p.norm() - 1.2, 0.5 - p.norm()); });
}

UnreachedTarget leftBy(const SurfaceMesh& surface, const ScalarImage& field)
{
  return findUnreachedTarget(field, surface, awayFrom(field, surface));
}

bool mentions(const std::string& words, const std::string& what)
{
  return words.find(what) != std::string::npos;
}

} // namespace

TEST(UnreachedTarget, IsNothingWhereTheSurfaceLiesOnIt)
{
  const auto ball = shapes::sphereField(61, 1.6, 1.0);
  EXPECT_TRUE(leftBy(icosphere(4), *ball).isNothing());
  EXPECT_TRUE(leftBy(cubeSphere(16), *ball).isNothing());
  EXPECT_TRUE(leftBy(shapes::torus(64, 32, 1.0, 0.4), *ringField(0.4)).isNothing());
  EXPECT_EQ(inWords({}), "");
}

TEST(UnreachedTarget, IsAMembraneOverAHole)
{
  // The ring, and a disc in the middle of its hole.
  SurfaceMesh surface = shapes::torus(64, 32, 1.0, 0.4);
  const Index center = surface.vertexCount();
  surface.addPoint(Vec3(0, 0, 0.01));
  for (int i = 0; i < 12; ++i)
  {
    const double angle = 2.0 * 3.14159265 * i / 12;
    surface.addPoint(Vec3(0.3 * std::cos(angle), 0.3 * std::sin(angle), 0.01));
    surface.addFace({ center, center + 1 + i, center + 1 + (i + 1) % 12 });
  }
  const UnreachedTarget left = leftBy(surface, *ringField(0.4));
  ASSERT_EQ(left.membranes.size(), 1U);
  EXPECT_NEAR(left.membranes[0].width, 2.0 * 0.6, 0.02); // the hole's
  EXPECT_LT((left.membranes[0].middle - Vec3(0, 0, 0.01)).norm(), 1e-12);
  EXPECT_TRUE(left.pieces.empty());
  const std::string words = inWords(left);
  EXPECT_TRUE(mentions(words, "1 membrane spans a hole")) << words;
  EXPECT_TRUE(mentions(words, "1.2 wide at (0 0 0.01)")) << words;
  EXPECT_TRUE(mentions(words, "vtkShrinkWrap")) << words;
}

TEST(UnreachedTarget, IsAPartOfItsOwn)
{
  const SurfaceMesh one = shapes::transformed(icosphere(4, 0.4), 1.0, Vec3(0.8, 0, 0));
  const UnreachedTarget left = leftBy(one, *twoBalls());
  EXPECT_TRUE(left.membranes.empty());
  ASSERT_EQ(left.pieces.size(), 1U);
  EXPECT_NEAR(left.part, 0.5, 0.01);
  // Of the samples within two cells of it.
  EXPECT_NEAR(left.pieces[0].width, std::sqrt(3.0) * (0.8 + 2.0 * 0.0533), 0.2);
  EXPECT_LT((left.pieces[0].middle - Vec3(-0.8, 0, 0)).norm(), 0.5);
  EXPECT_TRUE(mentions(inWords(left), "50 % of the level's area is not reached, in 1 piece"))
    << inWords(left);
}

TEST(UnreachedTarget, IsAnInnerSide)
{
  const UnreachedTarget left = leftBy(icosphere(4, 1.2), *hollowBall());
  ASSERT_EQ(left.pieces.size(), 1U);
  EXPECT_NEAR(left.part, 0.25 / (0.25 + 1.44), 0.01);
}

TEST(UnreachedTarget, IsLookedForWhereAFlowShouldHaveArrived)
{
  FlowState state;
  state.record.time = 2.0;
  EXPECT_FALSE(shouldHaveArrived(state, 1.0, 1.0, 0.1)); // exp(-2) = 0.14
  EXPECT_TRUE(shouldHaveArrived(state, 1.0, 1.0, 0.2));
  EXPECT_TRUE(shouldHaveArrived(state, 1.0, 2.0, 0.1));
  EXPECT_FALSE(shouldHaveArrived(state, 3.0, 1.0, 0.2));
  state.hasConverged = true;
  EXPECT_TRUE(shouldHaveArrived(state, 3.0, 1.0, 0.2));
}

TEST(UnreachedTarget, OfASphereAroundARingIsItsHole)
{
  FlowOptions options;
  options.timeStep = 0.0;
  options.numberOfSteps = 60;
  options.curvatureSpeed = 0.1;
  options.curvatureRange = 0.1;
  const auto field = ringField(0.4);
  const auto start = std::make_shared<const SurfaceMesh>(icosphere(3, 1.8));
  SurfaceRemeshingOptions remeshing;
  remeshing.onlyDegenerate = true;
  SurfaceFlow flow(start, field, std::make_shared<SurfaceRemesher>(*start, remeshing), options);
  const double farthest = flow.record().maxDistance;
  EXPECT_EQ(unreachedInWords(*field, flow.state(), farthest, 1.0), ""); // still on its way
  flows::run(flow);
  const UnreachedTarget left = leftBy(flow.mesh(), *field);
  ASSERT_FALSE(left.membranes.empty());
  EXPECT_NEAR(left.membranes[0].width, 1.2, 0.15);
  EXPECT_LT(left.membranes[0].middle.norm(), 0.3);
  const std::string words = unreachedInWords(*field, flow.state(), farthest, 1.0);
  EXPECT_TRUE(mentions(words, "span")) << words;
}
