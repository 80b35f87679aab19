// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceGuard.h"

#include "Errors.h"
#include "Evolution/StateMeasures.h"
#include "Mesh/Angles.h"
#include "Mesh/MeshQuality.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace evolving;

TEST(SurfaceGuard, AcceptsAnOrdinaryStep)
{
  const SurfaceMesh start = shapes::bumpySphere(2);
  const SurfaceGuard check(start, Box(), 2.0);
  EXPECT_NO_THROW(check.require(start, Execution()));
  EXPECT_NO_THROW(check.require(shapes::transformed(start, 1.1, Vec3::Zero()), Execution()));
}

TEST(SurfaceGuard, AFlatStartMayStayFlat)
{
  SurfaceMesh sheet = shapes::sheet(4, true);
  const SurfaceGuard check(sheet, Box(), 1.0);
  sheet.points[7].z() = 1e-13;
  EXPECT_NO_THROW(check.require(sheet, Execution()));
  sheet.points[7].z() = 1e-3;
  EXPECT_THROW(check.require(sheet, Execution()), SolverError);
}

TEST(SurfaceGuard, RefusesPointsOutsideTheGuard)
{
  const SurfaceMesh start = icosphere(2);
  SurfaceMesh moved = start;
  moved.points[3] *= 2.5;
  EXPECT_THROW(SurfaceGuard(start, Box(), 2.0).require(moved, Execution()), SolverError);
  EXPECT_NO_THROW(SurfaceGuard(start, Box(), 3.0).require(moved, Execution()));
  const Box image(Vec3(-3, -3, -3), Vec3(3, 3, 3));
  EXPECT_NO_THROW(SurfaceGuard(start, image, 1.0).require(moved, Execution()));
}

TEST(SurfaceGuard, RefusesCoordinatesThatAreNotFinite)
{
  const SurfaceMesh start = icosphere(2);
  for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity() })
  {
    SurfaceMesh moved = start;
    moved.points[5].y() = bad;
    EXPECT_THROW(SurfaceGuard(start, Box(), 1.0).require(moved, Execution()), SolverError);
  }
}

TEST(SurfaceGuard, RefusesASurfaceThatHasVanished)
{
  const SurfaceMesh start = icosphere(2);
  EXPECT_THROW(SurfaceGuard(start, Box(), 2.0)
                 .require(shapes::transformed(start, 1e-5, Vec3::Zero()), Execution()),
    SolverError);
}

TEST(StateMeasures, SmallestAngleAgreesWithTheMeshQuality)
{
  for (const SurfaceMesh& mesh :
    { shapes::bumpySphere(4), cubeSphere(7), shapes::shakenSheet(9, true, 0.5, 2) })
  {
    EXPECT_NEAR(smallestAngle(mesh, Execution()), smallestAngle(mesh), 1e-10);
  }
  SurfaceMesh collapsed = icosphere(1);
  collapsed.points[0] = collapsed.points[static_cast<std::size_t>(collapsed.faceVertex(0, 1))];
  collapsed.points[static_cast<std::size_t>(collapsed.faceVertex(0, 0))] =
    collapsed.points[static_cast<std::size_t>(collapsed.faceVertex(0, 1))];
  EXPECT_EQ(smallestAngle(collapsed, Execution()), 0.0);
}

TEST(StateMeasures, MeasuresASphereBesideItsTarget)
{
  const SurfaceMesh mesh = icosphere(4, 2.0);
  StateArrays arrays;
  arrays.coVolume.assign(mesh.points.size(), 16.0 * Pi / 2562.0);
  arrays.distance.assign(mesh.points.size(), -0.5);
  arrays.distance[9] = 3.0;
  FlowRecord record;
  measureState(mesh, Vec3::Zero(), arrays, record, Execution());
  EXPECT_NEAR(record.area, 16.0 * Pi, 1e-9);
  EXPECT_NEAR(record.volume, 32.0 / 3.0 * Pi, 0.1);
  EXPECT_NEAR(record.meanDistance, 0.5 + 2.5 / 2562.0, 1e-12);
  EXPECT_EQ(record.maxDistance, 3.0);
}
