// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Operators/SpoiledElements.h"

#include <gtest/gtest.h>

using namespace evolving;

TEST(SpoiledElements, FlagsTurnedAndSharpenedElements)
{
  SurfaceMesh mesh;
  mesh.points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0.8, 0) };
  mesh.addFace({ 0, 1, 2 });
  const std::vector<Vec3> up(3, Vec3::UnitZ());
  const auto isSpoiled = [&](const Vec3& before, const Vec3& after)
  {
    std::vector<Vec3> old = mesh.points;
    old[2] = before;
    mesh.points[2] = after;
    return spoiledElements(mesh, old, up, 20.0, Execution())[0] != 0;
  };
  const Vec3 high(0.5, 0.8, 0);
  EXPECT_FALSE(isSpoiled(high, Vec3(0.5, 0.3, 0)));               // 31 degrees is still good
  EXPECT_TRUE(isSpoiled(high, Vec3(0.5, 0.1, 0)));                // 11 degrees is not
  EXPECT_TRUE(isSpoiled(high, Vec3(0.5, -0.8, 0)));               // turned over
  EXPECT_FALSE(isSpoiled(Vec3(0.5, 0.05, 0), Vec3(0.5, 0.1, 0))); // better than before
  EXPECT_FALSE(isSpoiled(Vec3(0.5, 0.05, 0), Vec3(0.5, 0.05, 0)));
}

TEST(SpoiledElements, FlagsElementsThatTurnAgainstTheirVertices)
{
  // A steep face that leans over: by a few degrees, but to the other side.
  SurfaceMesh mesh;
  mesh.points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0.05, 0.8) };
  mesh.addFace({ 0, 1, 2 });
  const std::vector<Vec3> up(3, Vec3::UnitZ());
  const std::vector<Vec3> before = mesh.points;
  mesh.points[2].y() = 0.02;
  EXPECT_EQ(spoiledElements(mesh, before, up, 20.0, Execution())[0], 0);
  mesh.points[2].y() = -0.02;
  EXPECT_EQ(spoiledElements(mesh, before, up, 20.0, Execution())[0], 1);
  const std::vector<Vec3> turned = mesh.points; // one that is turned may stay so
  mesh.points[2].y() = -0.03;
  EXPECT_EQ(spoiledElements(mesh, turned, up, 20.0, Execution())[0], 0);
}

TEST(SpoiledElements, FlagsSharpenedElementsWithStraightCorners)
{
  // A straight corner is none that a needle has: the polygon may not become one all the same.
  SurfaceMesh mesh;
  mesh.points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(1, 1, 0) };
  mesh.addFace({ 0, 1, 2, 3 });
  const std::vector<Vec3> up(4, Vec3::UnitZ());
  const std::vector<Vec3> before = mesh.points;
  mesh.points[3].y() = 0.1;
  EXPECT_EQ(spoiledElements(mesh, before, up, 20.0, Execution())[0], 1);
  mesh.points[3].y() = 0.5;
  EXPECT_EQ(spoiledElements(mesh, before, up, 20.0, Execution())[0], 0);
}

TEST(SpoiledElements, KnowsWhoSpoilsACap)
{
  // The base comes up to the apex, which itself moves away from it: too little for both.
  SurfaceMesh mesh;
  mesh.points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0.01, 0) };
  mesh.addFace({ 0, 1, 2 });
  const std::vector<Vec3> up(3, Vec3::UnitZ());
  const std::vector<Vec3> before = mesh.points;
  mesh.points = { Vec3(0, 0.1, 0), Vec3(1, 0, 0), Vec3(0.5, 0.03, 0) };
  const SpoiledElements elements(mesh, before, up, 20.0);
  EXPECT_TRUE(elements.isSpoiled(0));
  EXPECT_TRUE(elements.isSpoiledBy(0, 0));
  EXPECT_FALSE(elements.isSpoiledBy(0, 1)); // does not move
  EXPECT_FALSE(elements.isSpoiledBy(0, 2)); // improves it
}
