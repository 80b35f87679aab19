// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/InversionFreeMove.h"

#include "Remeshing/EditingChecks.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/Draws.h"
#include "Shapes/Sheets.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace
{

using namespace evolving;
using namespace evolving::editing;

/// The smallest cosine of the angle by which a face has turned.
double mostTurned(const EditableSurface& now, const EditableSurface& before)
{
  double least = 1.0;
  for (Index f = 0; f < now.faceSlots(); ++f)
  {
    if (now.hasFace(f))
    {
      const double cosine = now.doubleArea(f).normalized().dot(before.doubleArea(f).normalized());
      least = std::min(least, cosine);
    }
  }
  return least;
}

std::vector<Vec3> thrown(const EditableSurface& surface, double amount, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-amount, amount);
  std::vector<Vec3> points;
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    points.push_back(surface.point(v) + shapes::drawnVector(shift, random));
  }
  return points;
}

TEST(InversionFreeMove, SmallMovesAreAllMade)
{
  EditableSurface surface(icosphere(3));
  const std::vector<Vec3> points = thrown(surface, 0.01, 1);
  EXPECT_EQ(moveWithoutInversion(surface, points), 0);
  for (const Index v : verticesOf(surface))
  {
    ASSERT_EQ(surface.point(v), points[static_cast<std::size_t>(v)]);
  }
}

TEST(InversionFreeMove, WhatIsNoNumberStaysWhereItWas)
{
  const EditableSurface before(icosphere(2));
  EditableSurface surface = before;
  std::vector<Vec3> points = thrown(surface, 0.0, 1);
  points[7] = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  points[40].x() = std::numeric_limits<double>::infinity();
  EXPECT_GE(moveWithoutInversion(surface, points), 2);
  for (const Index v : verticesOf(surface))
  {
    ASSERT_EQ(surface.point(v), before.point(v));
  }
}

TEST(InversionFreeMove, NoFaceTurnsOver)
{
  for (const double amount : { 0.1, 0.2, 1.0 })
  {
    const EditableSurface before(icosphere(3));
    EditableSurface surface = before;
    const std::vector<Vec3> points = thrown(surface, amount, 2);
    const Index stayed = moveWithoutInversion(surface, points);
    EXPECT_GE(mostTurned(surface, before), 0.25);
    Index found = 0;
    for (const Index v : verticesOf(surface))
    {
      const bool isBack = surface.point(v) == before.point(v);
      EXPECT_TRUE(isBack || surface.point(v) == points[static_cast<std::size_t>(v)]);
      found += isBack ? 1 : 0;
    }
    EXPECT_EQ(found, stayed);
    EXPECT_GT(stayed, 0);
  }
}

TEST(InversionFreeMove, OnlyTheCornersOfTheTurnedFaceStay)
{
  const EditableSurface before(shapes::sheet(6, true));
  EditableSurface sheet = before;
  std::vector<Vec3> points = thrown(sheet, 0.0, 1);
  points[24] += Vec3(0.5, 0.0, 0.0); // over the next vertex
  points[0] += Vec3(-0.5, -0.5, 0.0);
  EXPECT_LE(moveWithoutInversion(sheet, points), 7);
  EXPECT_EQ(sheet.point(24), before.point(24));
  EXPECT_EQ(sheet.point(0), points[0]);
}

TEST(InversionFreeMove, IsTheSameOnAnyThreads)
{
  EditableSurface serial(icosphere(5));
  const std::vector<Vec3> points = thrown(serial, 0.02, 3);
  const Index stayed = moveWithoutInversion(serial, points);
  ASSERT_GT(stayed, 100);
  for (const int threads : { 1, 2, 8 })
  {
    EditableSurface surface(icosphere(5));
    EXPECT_EQ(moveWithoutInversion(surface, points, threadedExecution(threads, 5)), stayed);
    EXPECT_TRUE(surface.mesh() == serial.mesh());
  }
}

} // namespace
