// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/GrownParts.h"

#include "Mesh/SelfIntersections.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace evolving;

namespace
{

std::vector<Vec3> grown(const SurfaceMesh& mesh)
{
  return grownPoints(mesh, surfaceParts(mesh), selfIntersections(mesh));
}

} // namespace

TEST(GrownParts, MoveOutwardsByLessThanAMillionth)
{
  const SurfaceMesh mesh =
    shapes::merged(shapes::box(Vec3::Zero(), Vec3::Ones()), shapes::box({ 1, 0, 0 }, { 2, 1, 1 }));
  const double diagonal = boundingBox(mesh).diagonal().norm();
  const std::vector<Vec3> points = grown(mesh);
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    const Vec3 middle = v < 8 ? Vec3(0.5, 0.5, 0.5) : Vec3(1.5, 0.5, 0.5);
    const Vec3 move = points[v] - mesh.points[v];
    EXPECT_LT(move.norm(), 1e-6 * diagonal);
    EXPECT_GT((move.array() * (mesh.points[v] - middle).array()).minCoeff(), 0.0);
  }
}

TEST(GrownParts, ThatMeetNothingStay)
{
  const SurfaceMesh apart =
    shapes::merged(shapes::box(Vec3::Zero(), Vec3::Ones()), shapes::box({ 3, 0, 0 }, { 4, 1, 1 }));
  EXPECT_EQ(grown(apart), apart.points);
}

TEST(GrownParts, OpenOnesStay)
{
  const SurfaceMesh sheet = shapes::transformed(shapes::sheet(2, true), 1.0, { -0.5, 0, 1 });
  const SurfaceMesh mesh = shapes::merged(sheet, shapes::box(Vec3::Zero(), Vec3::Ones()));
  const std::vector<Vec3> points = grown(mesh);
  EXPECT_TRUE(std::equal(sheet.points.begin(), sheet.points.end(), points.begin()));
  EXPECT_NE(points, mesh.points);
}
