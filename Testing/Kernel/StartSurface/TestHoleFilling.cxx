// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/HoleFilling.h"

#include "Errors.h"
#include "Mesh/Angles.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/TopologySummary.h"
#include "Shapes/HoleyShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

SurfaceMesh allFilled(const SurfaceMesh& mesh)
{
  return fillHoles(mesh, boundaryLoops(mesh));
}

} // namespace

TEST(HoleFilling, ClosesADrilledSphereAndKeepsItsFaces)
{
  const SurfaceMesh mesh =
    drilledSphere({ Vec3::UnitX(), Vec3(-1.0, 2.0, 0.5), Vec3(0.0, -1.0, -1.0) }, 0.35);
  const SurfaceMesh filled = allFilled(mesh);
  ASSERT_GT(filled.faceCount(), mesh.faceCount());
  EXPECT_EQ(filled.points, mesh.points);
  EXPECT_TRUE(std::equal(
    mesh.cornerVertices.begin(), mesh.cornerVertices.end(), filled.cornerVertices.begin()));
  const TopologySummary summary = summarizeTopology(filled);
  EXPECT_TRUE(summary.isClosed() && summary.isManifold() && summary.isOriented());
  EXPECT_EQ(summary.genus(), 0);
  EXPECT_TRUE(selfIntersections(filled).empty());
  // Less the segments cut off: pi h^2 (3 - h) / 3 each.
  const double h = 1.0 - std::cos(0.35);
  EXPECT_NEAR(signedVolume(filled), 4.0 / 3.0 * Pi - Pi * h * h * (3.0 - h), 0.04);
  EXPECT_NEAR(signedVolume(allFilled(reversed(mesh))), -signedVolume(filled), 1e-12);
}

TEST(HoleFilling, DoesNotDependOnScaleAndPlace)
{
  const SurfaceMesh mesh = drilledSphere({ Vec3(0.3, 0.5, 1.0) }, 0.5);
  const SurfaceMesh filled = allFilled(mesh);
  for (const double scale : { 1e-4, 1e4 })
  {
    const SurfaceMesh other = allFilled(transformed(mesh, scale, scale * Vec3(300.0, -100.0, 0.0)));
    EXPECT_TRUE(summarizeTopology(other).isClosed());
    EXPECT_NEAR(surfaceArea(other) / (scale * scale), surfaceArea(filled), 1e-9);
  }
}

TEST(HoleFilling, UsesNoEdgeThatTheMeshHas)
{
  // A pyramid without its base, a rhombus, along whose shorter diagonal another body stands.
  const SurfaceMesh mesh = makeMesh({ { -0.3, 0, 0 }, { 0, -1, 0 }, { 0.3, 0, 0 }, { 0, 1, 0 },
                                      { 0, 0, -1 }, { 0, -0.1, 1 }, { 0, 0.1, 1 } },
    { { 1, 0, 4 }, { 2, 1, 4 }, { 3, 2, 4 }, { 0, 3, 4 }, { 0, 2, 6 }, { 2, 0, 5 }, { 0, 6, 5 },
      { 2, 5, 6 } });
  ASSERT_EQ(boundaryLoops(mesh).size(), 1U);
  const SurfaceMesh filled = allFilled(mesh);
  EXPECT_EQ(filled.faceCount(), mesh.faceCount() + 2);
  const TopologySummary summary = summarizeTopology(filled);
  EXPECT_TRUE(summary.isClosed() && summary.isOriented());
}

TEST(HoleFilling, FillsLongLoopsToo)
{
  const SurfaceMesh pipe = openCylinder(400, 2, 1.0, 0.5);
  const SurfaceMesh filled = allFilled(pipe);
  EXPECT_EQ(filled.faceCount(), pipe.faceCount() + 2 * 398);
  const TopologySummary summary = summarizeTopology(filled);
  EXPECT_TRUE(summary.isClosed() && summary.isOriented());
  EXPECT_NEAR(signedVolume(filled), 0.5 * 200.0 * std::sin(Pi / 200.0), 1e-12);
}

TEST(HoleFilling, CrossesNothingAtRaggedRims)
{
  // Least area alone cuts under the rim where a tongue of a strongly curved surface is in its way.
  std::mt19937 generator(5);
  const auto number = [&] { return static_cast<double>(generator()) / 4294967296.0; };
  for (int trial = 0; trial < 30; ++trial)
  {
    const double shift = 6.0 * number();
    const double reach = 0.4 + 0.5 * number();
    SurfaceMesh mesh = facesWhere(unitIcosphere(4),
      [&](const Vec3& p)
      {
        const double around = std::atan2(p.y(), p.x());
        const double ragged = 0.25 * std::sin(5.0 * around + shift) + 0.15 * std::sin(9.0 * around);
        return std::atan2(std::hypot(p.x(), p.y()), p.z()) > (1.0 + 0.6 * ragged) * reach;
      });
    for (Vec3& point : mesh.points)
    {
      point.x() *= 0.5;
      point += 0.01 * randomPoint(generator);
    }
    const SurfaceMesh filled = allFilled(mesh);
    EXPECT_TRUE(summarizeTopology(filled).isClosed());
    EXPECT_TRUE(selfIntersections(filled).empty()) << trial;
  }
}

TEST(HoleFilling, OfALongLoopCanBeStopped)
{
  constexpr Index Corners = 5000;
  SurfaceMesh cone;
  const Index tip = cone.addPoint(Vec3::UnitZ());
  for (Index k = 0; k < Corners; ++k)
  {
    const double angle = 2.0 * 3.141592653589793 * k / Corners;
    cone.addPoint(Vec3(std::cos(angle), std::sin(angle), 0.0));
  }
  for (Index k = 0; k < Corners; ++k)
  {
    cone.addFace({ tip, tip + 1 + k, tip + 1 + (k + 1) % Corners });
  }
  // The only cap begins at half of the way.
  double told = 0.0;
  const Execution stopping(
    nullptr, [&](double fraction) { told = fraction; }, [&] { return told > 0.5; });
  EXPECT_THROW(fillHoles(cone, boundaryLoops(cone), stopping), Cancelled);
  EXPECT_LT(told, 0.75);
}
