// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/OutwardOrientation.h"
#include "Mesh/Angles.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;
using namespace evolving::shapes;

TEST(OutwardOrientation, LeavesAnOutwardSurfaceAlone)
{
  const SurfaceMesh mesh = torus(20, 10, 1.0, 0.3);
  SurfaceMesh oriented = mesh;
  const OrientationSummary summary = orientOutwards(oriented);
  EXPECT_EQ(oriented.cornerVertices, mesh.cornerVertices);
  EXPECT_EQ(summary.turnedFaces, 0);
  EXPECT_EQ(summary.components, 1);
  EXPECT_TRUE(summary.isClosed());
  EXPECT_TRUE(summary.isOriented());
  EXPECT_FALSE(summary.componentsOverlap);
  EXPECT_EQ(summary.openLength, 0.0);
}

TEST(OutwardOrientation, TurnsAnInsideOutSurface)
{
  SurfaceMesh mesh = reversed(sphere(2));
  const OrientationSummary summary = orientOutwards(mesh);
  EXPECT_EQ(summary.turnedFaces, mesh.faceCount());
  EXPECT_NEAR(signedVolume(mesh), signedVolume(sphere(2)), 1e-12);
}

TEST(OutwardOrientation, TurnsSingleFaces)
{
  SurfaceMesh mesh = turned(sphere(2), [](Index face) { return face % 4 == 1; });
  const OrientationSummary summary = orientOutwards(mesh);
  EXPECT_EQ(summary.turnedFaces, mesh.faceCount() / 4);
  EXPECT_TRUE(summary.isOriented());
  EXPECT_NEAR(signedVolume(mesh), signedVolume(sphere(2)), 1e-12);
}

TEST(OutwardOrientation, TurnsSeparateComponentsSeparately)
{
  SurfaceMesh mesh = merged(sphere(2), reversed(sphere(2, 1.0, Vec3(3, 0, 0))));
  const OrientationSummary summary = orientOutwards(mesh);
  EXPECT_EQ(summary.components, 2);
  EXPECT_FALSE(summary.componentsOverlap);
  EXPECT_NEAR(signedVolume(mesh), 2.0 * signedVolume(sphere(2)), 1e-12);
}

TEST(OutwardOrientation, KeepsACavityHollow)
{
  const double shell = signedVolume(sphere(2)) * (1.0 - 0.125);
  const SurfaceMesh hollow = merged(sphere(2), reversed(sphere(2, 0.5)));
  for (SurfaceMesh mesh : { hollow, reversed(hollow) })
  {
    const OrientationSummary summary = orientOutwards(mesh);
    EXPECT_TRUE(summary.componentsOverlap);
    EXPECT_NEAR(signedVolume(mesh), shell, 1e-12);
  }
}

TEST(OutwardOrientation, TurnsAnOpenBowlButNotASheet)
{
  SurfaceMesh inward = reversed(bowl(3, 0.3));
  const OrientationSummary summary = orientOutwards(inward);
  EXPECT_EQ(summary.turnedFaces, inward.faceCount());
  EXPECT_GT(summary.boundaryEdges, 0);
  EXPECT_NEAR(summary.openLength, 2.0 * Pi * std::sqrt(1.0 - 0.09), 0.6);
  SurfaceMesh sheet = triangleMesh(Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(1, 0, 0));
  EXPECT_EQ(orientOutwards(sheet).turnedFaces, 0);
  EXPECT_NEAR(orientOutwards(sheet).openLength, 2.0 + std::sqrt(2.0), 1e-12);
}

TEST(OutwardOrientation, ReportsAOneSidedSurface)
{
  SurfaceMesh mesh = fanned(moebiusBand(24, 1.0, 0.3));
  const OrientationSummary summary = orientOutwards(mesh);
  EXPECT_FALSE(summary.isOriented());
  EXPECT_FALSE(summary.isClosed());
}

TEST(OutwardOrientation, ReportsEdgesOfMoreThanTwoFaces)
{
  // Two boxes that share an edge: closed in the sense of chains, but not a manifold.
  SurfaceMesh mesh;
  const SurfaceMesh soup =
    merged(box(Vec3(0, 0, 0), Vec3(1, 1, 1)), box(Vec3(1, 1, 0), Vec3(2, 2, 1)));
  mesh = weldCoincidentPoints(soup);
  const OrientationSummary summary = orientOutwards(mesh);
  EXPECT_EQ(summary.nonManifoldEdges, 1);
  EXPECT_EQ(summary.boundaryEdges, 0);
  EXPECT_EQ(summary.openLength, 0.0);
  EXPECT_NEAR(signedVolume(mesh), 2.0, 1e-12);
}

TEST(OutwardOrientation, GivesOpenEdgesAsFacesRunAlongThemOnceForEachFace)
{
  SurfaceMesh mesh;
  mesh.points = { Vec3(0, 0, 0), Vec3(0, 0, 2), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-1, -1, 0) };
  for (const Index tip : { 2, 3, 4 })
  {
    mesh.addFace({ 1, 0, tip });
  }
  const OrientationSummary summary = orientOutwards(mesh);
  std::vector<std::array<Index, 2>> expected;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    for (Index k = 0; k < 3; ++k)
    {
      expected.push_back({ mesh.faceVertex(face, k), mesh.faceVertex(face, (k + 1) % 3) });
    }
  }
  std::vector<std::array<Index, 2>> open = summary.openEdges;
  std::sort(open.begin(), open.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(open, expected);
}
