// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/Angles.h"
#include "Mesh/MeshQuality.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace evolving
{

using namespace evolving::shapes;

namespace
{

/// Triangle number i of a row has the smallest angle angles[i], in degrees.
SurfaceMesh trianglesWithAngles(const std::vector<double>& angles)
{
  SurfaceMesh mesh;
  for (const double angle : angles)
  {
    const double radians = angle * Pi / 180.0;
    const Index tip = mesh.addPoint(Vec3::Zero());
    mesh.addPoint({ 1, 0, 0 });
    mesh.addPoint({ std::cos(radians), std::sin(radians), 0 });
    mesh.addFace({ tip, tip + 1, tip + 2 });
  }
  return mesh;
}

TEST(MeshQuality, EmptyMeshIsAllZero)
{
  const SurfaceMesh empty;
  EXPECT_EQ(smallestAngle(empty), 0.0);
  EXPECT_EQ(meanEdgeLength(empty), 0.0);
  EXPECT_EQ(summarizeAngles(empty).mean, 0.0);
  EXPECT_EQ(summarizeAngles(empty).firstPercentile, 0.0);
}

TEST(MeshQuality, AnglesOfKnownFaces)
{
  EXPECT_NEAR(smallestAngle(unitIcosphere(0)), 60.0, 1e-12);
  EXPECT_NEAR(smallestAngle(unitCube()), 90.0, 1e-12);
  EXPECT_NEAR(smallestAngle(cornerTetrahedron()), 45.0, 1e-12);
  EXPECT_NEAR(smallestAngle(cornerTetrahedron(), 3), 60.0, 1e-12);
  const double golden = (1.0 + std::sqrt(5.0)) / 2.0;
  const SurfaceMesh tall =
    makeMesh({ { -0.5, 0, 0 }, { 0.5, 0, 0 }, { 0, std::sqrt(golden * golden - 0.25), 0 } },
      { { 0, 1, 2 } });
  EXPECT_NEAR(smallestAngle(tall), 36.0, 1e-12);
}

TEST(MeshQuality, SmallAnglesAreAccurate)
{
  // An arc cosine would lose half of the digits here.
  for (const double angle : { 1e-3, 1e-6, 1e-9, 1e-12 })
  {
    EXPECT_NEAR(smallestAngle(trianglesWithAngles({ angle })) / angle, 1.0, 1e-9);
  }
}

TEST(MeshQuality, AnglesDoNotDependOnPlaceRotationOrScale)
{
  std::mt19937 generator(4);
  const SurfaceMesh shape = quadTorus(9, 6, 2.0, 0.7);
  const double expected = smallestAngle(shape);
  EXPECT_NEAR(smallestAngle(mapped(shape, randomRotation(generator))), expected, 1e-12);
  EXPECT_NEAR(smallestAngle(transformed(shape, 1e-30, Vec3::Zero())), expected, 1e-12);
  EXPECT_NEAR(smallestAngle(transformed(shape, 1.0, { 1e6, 1e6, 1e6 })), expected, 1e-6);
}

TEST(MeshQuality, CollapsedFacesHaveAngleZero)
{
  const SurfaceMesh needle = makeMesh({ { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 } }, { { 0, 1, 2 } });
  EXPECT_EQ(smallestAngle(needle), 0.0);
  const SurfaceMesh point = makeMesh({ { 1, 2, 3 }, { 1, 2, 3 }, { 1, 2, 3 } }, { { 0, 1, 2 } });
  EXPECT_EQ(smallestAngle(point), 0.0);
}

TEST(MeshQuality, AVanishingEdgeIsAngleZeroWhereverTheFaceLies)
{
  // Signed zeros: the products of the vanishing edge are -0 in half of the directions.
  for (const double sign : { 1.0, -1.0 })
  {
    const SurfaceMesh quad = transformed(
      makeMesh({ { 0, 0, 0 }, { 0, 0, 0 }, { 2, 1, 1 }, { 1, 2, 1 } }, { { 0, 1, 2, 3 } }), sign,
      Vec3::Zero());
    EXPECT_EQ(smallestAngle(quad), 0.0);
  }
}

TEST(MeshQuality, SummaryOfAKnownDistribution)
{
  std::vector<double> angles;
  for (int i = 0; i < 200; ++i)
  {
    angles.push_back(1.0 + (i * 37) % 200 * 0.25); // 1 to 50.75 in mixed order
  }
  const AngleSummary summary = summarizeAngles(trianglesWithAngles(angles));
  EXPECT_NEAR(summary.smallest, 1.0, 1e-9);
  EXPECT_NEAR(summary.firstPercentile, 1.5, 1e-9);
  EXPECT_NEAR(summary.mean, 25.875, 1e-9);
}

TEST(MeshQuality, PercentileOfFewFacesIsTheSmallest)
{
  const AngleSummary summary = summarizeAngles(trianglesWithAngles({ 30.0, 20.0, 50.0 }));
  EXPECT_NEAR(summary.firstPercentile, 20.0, 1e-12);
  EXPECT_NEAR(summary.smallest, 20.0, 1e-12);
  EXPECT_NEAR(summary.mean, 100.0 / 3.0, 1e-12);
}

TEST(MeshQuality, MeanEdgeLength)
{
  EXPECT_NEAR(meanEdgeLength(unitCube()), 1.0, 1e-15);
  EXPECT_NEAR(meanEdgeLength(cornerTetrahedron()), (1.0 + std::sqrt(2.0)) / 2.0, 1e-15);
  EXPECT_NEAR(meanEdgeLength(transformed(unitCube(), 3.0, { 1e5, 0, 0 })), 3.0, 1e-9);
}

} // namespace

} // namespace evolving
