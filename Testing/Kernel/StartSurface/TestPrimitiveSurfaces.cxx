// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/PrimitiveSurfaces.h"

#include "Checks/ClosedSurface.h"
#include "Errors.h"
#include "Mesh/Angles.h"
#include "Mesh/MeshQuality.h"
#include "Mesh/MeshTopology.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

using namespace evolving;

namespace
{

void expectSphereTopology(const SurfaceMesh& mesh)
{
  const TopologySummary summary = checks::expectClosedManifold(mesh);
  EXPECT_EQ(summary.components, 1);
  EXPECT_EQ(summary.genus(), 0);
  EXPECT_GT(signedVolume(mesh), 0.0);
  std::set<std::array<double, 3>> distinct;
  for (const Vec3& p : mesh.points)
  {
    distinct.insert({ p.x(), p.y(), p.z() });
  }
  EXPECT_EQ(distinct.size(), mesh.points.size());
}

} // namespace

TEST(PrimitiveSurfaces, IcosphereHasTheCountsAndValencesOfItsLevel)
{
  const Index expected[] = { 12, 42, 162, 642, 2562 };
  for (int level = 0; level < 5; ++level)
  {
    const SurfaceMesh mesh = icosphere(level);
    expectSphereTopology(mesh);
    EXPECT_EQ(mesh.vertexCount(), expected[level]);
    EXPECT_EQ(mesh.faceCount(), 2 * (expected[level] - 2));
    const MeshTopology topology(mesh);
    int irregular = 0;
    for (Index v = 0; v < mesh.vertexCount(); ++v)
    {
      irregular += topology.ringVertices(v).size() == 5 ? 1 : 0;
    }
    EXPECT_EQ(irregular, 12);
  }
}

TEST(PrimitiveSurfaces, IcosahedronIsRegular)
{
  const SurfaceMesh mesh = icosphere(0, 2.0);
  // The edge of an icosahedron in a sphere of radius 2.
  const double edge = 2.0 / std::sin(0.4 * Pi);
  EXPECT_NEAR(meanEdgeLength(mesh), edge, 1e-14);
  EXPECT_NEAR(smallestAngle(mesh), 60.0, 1e-12);
  EXPECT_NEAR(signedVolume(mesh), 5.0 / 12.0 * (3.0 + std::sqrt(5.0)) * std::pow(edge, 3), 1e-12);
}

TEST(PrimitiveSurfaces, SphereVerticesLieOnTheSphereAndVolumeConvergesInSecondOrder)
{
  const Vec3 centre(3.0, -2.0, 100.0);
  double lastIcoError = 0.0;
  double lastCubeError = 0.0;
  for (int level = 2; level < 6; ++level)
  {
    const SurfaceMesh ico = icosphere(level, 0.5, centre);
    const SurfaceMesh cube = cubeSphere(2 << level, 0.5, centre);
    for (const SurfaceMesh* mesh : { &ico, &cube })
    {
      for (const Vec3& point : mesh->points)
      {
        ASSERT_NEAR((point - centre).norm(), 0.5, 1e-13);
      }
    }
    const double icoError = Pi / 6.0 - signedVolume(ico);
    const double cubeError = Pi / 6.0 - signedVolume(cube);
    EXPECT_GT(icoError, 0.0);
    EXPECT_GT(cubeError, 0.0);
    if (level > 2)
    {
      EXPECT_NEAR(lastIcoError / icoError, 4.0, 0.1);
      EXPECT_NEAR(lastCubeError / cubeError, 4.0, 0.1);
    }
    lastIcoError = icoError;
    lastCubeError = cubeError;
  }
}

TEST(PrimitiveSurfaces, CubeSphereHasTheCountsOfItsDivisions)
{
  const std::pair<int, Index> expected[] = { { 1, 8 }, { 3, 56 }, { 6, 218 }, { 12, 866 } };
  for (const auto& [divisions, vertices] : expected)
  {
    const SurfaceMesh mesh = cubeSphere(divisions);
    expectSphereTopology(mesh);
    EXPECT_EQ(mesh.vertexCount(), vertices);
    EXPECT_EQ(mesh.faceCount(), 6 * divisions * divisions);
  }
}

TEST(PrimitiveSurfaces, CubeSphereIsCutAtEqualAngles)
{
  // Along the middle of a side, through its centre: neighbours are 90 degrees / n apart.
  const int n = 8;
  const SurfaceMesh mesh = cubeSphere(n);
  int found = 0;
  for (const Vec3& point : mesh.points)
  {
    if (point.z() > 0.7 && std::abs(point.y()) < 1e-14)
    {
      const double step = std::atan2(point.x(), point.z()) / (Pi / 2.0 / n);
      EXPECT_NEAR(step, std::round(step), 1e-12);
      ++found;
    }
  }
  EXPECT_EQ(found, n + 1);
}

TEST(PrimitiveSurfaces, BoxHasItsSidesAndIsExact)
{
  const Vec3 half(0.5, 1.0, 3.0);
  const Vec3 centre(-1.0, 4.0, 0.25);
  const SurfaceMesh mesh = subdividedBox(5, half, centre);
  expectSphereTopology(mesh);
  EXPECT_EQ(mesh.vertexCount(), 152);
  EXPECT_NEAR(signedVolume(mesh), 12.0, 1e-12);
  EXPECT_NEAR(surfaceArea(mesh), 2.0 * (2.0 + 6.0 + 12.0), 1e-12);
  EXPECT_NEAR((boundingBox(mesh).min() - (centre - half)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((boundingBox(mesh).max() - (centre + half)).norm(), 0.0, 1e-14);
  EXPECT_NEAR(signedVolume(subdividedBox(1)), 1.0, 1e-15);
}

TEST(PrimitiveSurfaces, RefusesParametersOutOfRange)
{
  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(icosphere(-1), InputError);
  EXPECT_THROW(icosphere(MaximumIcosphereLevel + 1), InputError);
  EXPECT_THROW(icosphere(1, 0.0), InputError);
  EXPECT_THROW(icosphere(1, notANumber), InputError);
  EXPECT_THROW(icosphere(1, 1.0, Vec3(0.0, notANumber, 0.0)), InputError);
  EXPECT_THROW(cubeSphere(0), InputError);
  EXPECT_THROW(cubeSphere(2, -1.0), InputError);
  EXPECT_THROW(subdividedBox(MaximumCubeDivisions + 1), InputError);
  EXPECT_THROW(subdividedBox(2, Vec3(1.0, 0.0, 1.0)), InputError);
}
