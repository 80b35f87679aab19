// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/OpenEdgeCaps.h"

#include "Distance/ClosestTriangles.h"
#include "Distance/DistanceTarget.h"
#include "Distance/Signs/WindingNumber.h"
#include "Mesh/Angles.h"
#include "Mesh/MeshQuality.h"
#include "Mesh/TriangleEdges.h"
#include "Shapes/Draws.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

SurfaceMesh capsOf(const DistanceTarget& target)
{
  SurfaceMesh caps;
  caps.points = target.mesh.points;
  for (const auto& [a, b, c] : capsOver(target.orientation.openEdges, caps.vertexCount()))
  {
    caps.addFace({ a, b, c });
  }
  return caps;
}

/// Edges along which the directed faces do not cancel.
int openEdgeCount(const SurfaceMesh& mesh)
{
  const TriangleEdges edges(mesh);
  int open = 0;
  for (Index edge = 0; edge < edges.edgeCount(); ++edge)
  {
    int upwards = 0;
    for (const Index* corner = edges.begin(edge); corner != edges.end(edge); ++corner)
    {
      upwards += TriangleEdges::runsUpwards(mesh, *corner) ? 1 : -1;
    }
    open += upwards != 0 ? 1 : 0;
  }
  return open;
}

/// Five triangles that have one edge in common.
SurfaceMesh sheetsAroundAnEdge()
{
  SurfaceMesh mesh;
  mesh.addPoint(Vec3(0, 0, 0));
  mesh.addPoint(Vec3(0, 0, 1));
  for (int k = 0; k < 5; ++k)
  {
    mesh.addPoint(Vec3(std::cos(k), std::sin(k), 0.3));
    mesh.addFace({ 0, 1, k + 2 });
  }
  return mesh;
}

std::vector<SurfaceMesh> openShapes()
{
  const auto everyFiftieth = [](Index face) { return face % 50 == 7; };
  const auto everyNinth = [](Index face) { return face % 9 == 0; };
  return { bowl(3, 0.3), without(sphere(3), everyFiftieth),
    without(turned(sphere(3), everyNinth), everyFiftieth), randomSoup(200, 0.5, 3),
    sheetsAroundAnEdge(),
    without(box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), [](Index f) { return f < 2; }),
    merged(bowl(2, 0.1), reversed(bowl(2, -0.2))), without(torus(30, 12, 1.0, 0.3), everyNinth) };
}

/// A ring of n edges round a cylinder's end.
SurfaceMesh openCylinder(int around)
{
  SurfaceMesh mesh;
  for (int k = 0; k < around; ++k)
  {
    const double angle = 2.0 * Pi * k / around;
    mesh.addPoint(Vec3(std::cos(angle), std::sin(angle), 0.0));
    mesh.addPoint(Vec3(std::cos(angle), std::sin(angle), 5.0));
  }
  for (Index k = 0; k < around; ++k)
  {
    const Index next = (k + 1) % around;
    mesh.addFace({ 2 * k, 2 * next, 2 * next + 1 });
    mesh.addFace({ 2 * k, 2 * next + 1, 2 * k + 1 });
  }
  return mesh;
}

} // namespace

TEST(OpenEdgeCaps, CloseAnySurface)
{
  for (const SurfaceMesh& mesh : openShapes())
  {
    const DistanceTarget target = makeDistanceTarget(mesh);
    const SurfaceMesh caps = capsOf(target);
    ASSERT_GT(openEdgeCount(target.mesh), 0);
    EXPECT_LT(caps.faceCount(), static_cast<Index>(target.orientation.openEdges.size()));
    SurfaceMesh both = target.mesh;
    for (Index face = 0; face < caps.faceCount(); ++face)
    {
      both.addFace(
        { caps.faceVertex(face, 0), caps.faceVertex(face, 1), caps.faceVertex(face, 2) });
    }
    EXPECT_EQ(openEdgeCount(both), 0);
  }
}

TEST(OpenEdgeCaps, AndTheSurfaceHaveAWholeWindingNumber)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  for (const SurfaceMesh& mesh : openShapes())
  {
    const DistanceTarget target = makeDistanceTarget(mesh);
    std::vector<Triangle> triangles = trianglesOf(target.mesh);
    const std::vector<Triangle> caps = trianglesOf(capsOf(target));
    triangles.insert(triangles.end(), caps.begin(), caps.end());
    for (int n = 0; n < 50; ++n)
    {
      const Vec3 point = shapes::drawnVector(uniform, random);
      double sum = 0.0;
      for (const Triangle& triangle : triangles)
      {
        sum += windingNumber(triangle, point);
      }
      EXPECT_NEAR(sum, std::round(sum), 1e-9);
    }
  }
}

TEST(OpenEdgeCaps, OfAClosedSurfaceAreNone)
{
  EXPECT_EQ(capsOf(makeDistanceTarget(sphere(3))).faceCount(), 0);
  EXPECT_TRUE(capsOver({}, 0).empty());
}

TEST(OpenEdgeCaps, OverARingAreLargeInTheMiddleAndShortAtTheEdges)
{
  const int around = 1000;
  const SurfaceMesh caps = capsOf(makeDistanceTarget(openCylinder(around)));
  EXPECT_EQ(caps.faceCount(), 2 * (around - 2));
  EXPECT_NEAR(surfaceArea(caps), 2.0 * Pi, 1e-3);
  int longOnes = 0;
  for (Index face = 0; face < caps.faceCount(); ++face)
  {
    longOnes += (caps.facePoint(face, 0) - caps.facePoint(face, 2)).norm() > 0.11 ? 1 : 0;
  }
  EXPECT_EQ(longOnes, 2 * (2 + 4 + 8 + 16 + 32)); // arcs of 1/64 of the circle are shorter
}

TEST(OpenEdgeCaps, OverACrackHaveNoArea)
{
  // Two halves of a plate; one has a corner more on the line along which they meet.
  SurfaceMesh plate;
  for (const Vec3& point :
    { Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0.3, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0) })
  {
    plate.addPoint(point);
  }
  plate.addFace({ 0, 1, 3 });
  plate.addFace({ 0, 4, 2 });
  plate.addFace({ 2, 4, 1 });
  const auto caps = capsOver({ { 0, 1 }, { 1, 2 }, { 2, 0 } }, plate.vertexCount());
  ASSERT_EQ(caps.size(), 1u);
  const auto& [a, b, c] = caps[0];
  const Triangle cap{ { plate.points[at(a)], plate.points[at(b)], plate.points[at(c)] } };
  EXPECT_EQ(cap.doubleAreaNormal().norm(), 0.0);
}
