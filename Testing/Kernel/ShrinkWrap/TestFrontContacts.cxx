// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/FrontContacts.h"

#include "Remeshing/RemeshingShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

using namespace evolving;

constexpr double Half = 0.05;
constexpr double Before = 0.1;

/// A sheet between two fronts that have come within 2 Half of each other.
SurfaceMesh doubleSheet()
{
  return shapes::triangleBox(10, Vec3(1.0, 1.0, Half));
}

/// Where its points were when the fronts were 2 Before apart.
std::vector<Vec3> pointsBefore(const SurfaceMesh& sheet)
{
  std::vector<Vec3> points = sheet.points;
  for (Vec3& p : points)
  {
    p.z() *= Before / Half;
  }
  return points;
}

bool isOnRim(const Vec3& point)
{
  return point.cwiseAbs().head<2>().maxCoeff() > 0.99;
}

TEST(FrontContacts, FrontsGoBackToWhereTheyWere)
{
  SurfaceMesh sheet = doubleSheet();
  const std::vector<Vec3> before = pointsBefore(sheet);
  const std::vector<double> far(sheet.points.size(), 1.0);
  const Index back = keepFrontsApart(sheet, before, far, 0.15);
  Index inner = 0;
  for (std::size_t v = 0; v < before.size(); ++v)
  {
    if (!isOnRim(before[v]))
    {
      ++inner;
      EXPECT_LT((sheet.points[v] - before[v]).norm(), 1e-12);
    }
  }
  EXPECT_EQ(inner, 2 * 81);
  EXPECT_GE(back, inner);
}

TEST(FrontContacts, NothingMovesWhereFrontsAreFarApartOrTheTargetIsNear)
{
  SurfaceMesh sheet = doubleSheet();
  const SurfaceMesh same = sheet;
  const std::vector<Vec3> before = pointsBefore(sheet);
  const std::vector<double> far(sheet.points.size(), 1.0);
  EXPECT_EQ(keepFrontsApart(sheet, before, far, 0.09), 0); // of a thickness of 0.1
  const std::vector<double> near(sheet.points.size(), -0.14);
  EXPECT_EQ(keepFrontsApart(sheet, before, near, 0.15), 0);
  EXPECT_TRUE(sheet == same);
}

TEST(FrontContacts, OnlyFarVerticesAreTakenBack)
{
  SurfaceMesh sheet = doubleSheet();
  const SurfaceMesh same = sheet;
  std::vector<double> distance(sheet.points.size(), 1.0);
  for (std::size_t v = 0; v < distance.size(); ++v)
  {
    distance[v] = sheet.points[v].x() > 0.01 ? 0.1 : 1.0;
  }
  EXPECT_GT(keepFrontsApart(sheet, pointsBefore(sheet), distance, 0.15), 80);
  for (std::size_t v = 0; v < distance.size(); ++v)
  {
    EXPECT_TRUE(same.points[v].x() <= 0.01 || sheet.points[v] == same.points[v]);
  }
}

TEST(FrontContacts, MovesApartAndAlongAreKept)
{
  // Fronts that drew back while they slid.
  SurfaceMesh sheet = doubleSheet();
  const SurfaceMesh same = sheet;
  std::vector<Vec3> before = sheet.points;
  for (Vec3& p : before)
  {
    p = Vec3(p.x() - 0.03, p.y(), 0.5 * p.z());
  }
  const std::vector<double> far(before.size(), 1.0);
  EXPECT_GT(keepFrontsApart(sheet, before, far, 0.15), 0);
  for (std::size_t v = 0; v < before.size(); ++v)
  {
    EXPECT_TRUE(isOnRim(same.points[v]) || sheet.points[v] == same.points[v]);
  }
}

TEST(FrontContacts, ABallHasNoneButThroughItsMiddle)
{
  SurfaceMesh ball = icosphere(3);
  const std::vector<Vec3> before = shapes::transformed(ball, 1.1, Vec3::Zero()).points;
  const std::vector<double> far(before.size(), 10.0);
  EXPECT_EQ(keepFrontsApart(ball, before, far, 1.9), 0);
  EXPECT_EQ(keepFrontsApart(ball, before, far, 2.1), ball.vertexCount());
}

TEST(FrontContacts, AreTheSameOnAnyThreads)
{
  SurfaceMesh serial = doubleSheet();
  const std::vector<Vec3> before = pointsBefore(serial);
  const std::vector<double> far(before.size(), 1.0);
  keepFrontsApart(serial, before, far, 0.15);
  SurfaceMesh sheet = doubleSheet();
  keepFrontsApart(sheet, before, far, 0.15, threadedExecution(4, 2));
  EXPECT_TRUE(sheet == serial);
}

} // namespace
