// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/SolidSheets.h"

#include "Mesh/SurfaceParts.h"
#include "Mesh/TopologySummary.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace evolving;

namespace
{

bool everywhere(const Vec3& /*point*/)
{
  return true;
}

/// A solid that is one closed manifold, outwards.
SurfaceMesh solid(const SurfaceMesh& sheet, double half)
{
  const auto mesh = solidSheets(sheet, everywhere, half);
  EXPECT_TRUE(mesh);
  const TopologySummary topology = summarizeTopology(mesh.value_or(sheet));
  EXPECT_TRUE(topology.isClosed() && topology.isManifold() && topology.isOriented());
  EXPECT_EQ(topology.components, 1);
  return mesh.value_or(sheet);
}

/// The unit sphere below a height.
SurfaceMesh cup(double height)
{
  return shapes::facesWhere(icosphere(4), [height](const Vec3& p) { return p.z() < height; });
}

/// Five sides of the unit cube, of triangles.
SurfaceMesh openBox()
{
  return weldCoincidentPoints(shapes::facesWhere(
    shapes::triangleBox(4, Vec3::Constant(0.5)), [](const Vec3& p) { return p.z() < 0.49; }));
}

} // namespace

TEST(SolidSheets, OfASquareIsAPlate)
{
  const SurfaceMesh plate = solid(shapes::sheet(5, true), 0.05);
  EXPECT_NEAR(signedVolume(plate), 0.1, 1e-12);
  EXPECT_NEAR(surfaceArea(plate), 2.0 + 4.0 * 0.1, 1e-12);
  EXPECT_EQ(summarizeTopology(plate).genus(), 0);
}

TEST(SolidSheets, HaveAHandleForEveryHole)
{
  const SurfaceMesh ring = solid(shapes::fanned(shapes::annulus(24)), 0.1);
  EXPECT_EQ(summarizeTopology(ring).genus(), 1);
}

TEST(SolidSheets, AreAsThickAroundEdges)
{
  const SurfaceMesh box = solid(openBox(), 0.05);
  EXPECT_TRUE(boundingBox(box).min().isApprox(Vec3::Constant(-0.55), 1e-9));
  EXPECT_NEAR(boundingBox(box).max().x(), 0.55, 1e-9);
  // The outer box less the inner one; its rim is level with the sheet's.
  EXPECT_NEAR(signedVolume(box), 1.1 * 1.1 * 1.05 - 0.9 * 0.9 * 0.95, 1e-9);
}

TEST(SolidSheets, DoNotAskHowFacesAreTurned)
{
  std::mt19937 generator(2);
  const SurfaceMesh bowl = cup(0.3);
  const double volume = signedVolume(solid(bowl, 0.05));
  EXPECT_GT(volume, 0.0);
  EXPECT_NEAR(signedVolume(solid(reversed(bowl), 0.05)), volume, 1e-12);
  const SurfaceMesh mixed = shapes::turned(bowl, [](Index face) { return face % 3 == 0; });
  EXPECT_NEAR(signedVolume(solid(mixed, 0.05)), volume, 1e-12);
}

TEST(SolidSheets, LeaveClosedPartsAndThoseThatAreNoSheets)
{
  const SurfaceMesh ball = shapes::transformed(icosphere(2), 1.0, Vec3(5, 0, 0));
  EXPECT_FALSE(solidSheets(ball, everywhere, 0.1));
  EXPECT_FALSE(solidSheets(
    cup(0.3), [](const Vec3& p) { return p.x() < 0.3; }, 0.1));
  const SurfaceMesh both = *solidSheets(shapes::merged(cup(0.3), ball), everywhere, 0.05);
  EXPECT_EQ(surfaceParts(both).list.size(), 2U);
  EXPECT_NEAR(signedVolume(both), signedVolume(solid(cup(0.3), 0.05)) + signedVolume(ball), 1e-9);
}

TEST(SolidSheets, LeavePartsWhoseSidesWouldCross)
{
  EXPECT_FALSE(solidSheets(cup(0.3), everywhere, 1.2));
}

TEST(SolidSheets, LeaveOneSidedParts)
{
  SurfaceMesh strip; // of Moebius
  constexpr Index Count = 24;
  for (Index i = 0; i < Count; ++i)
  {
    const double angle = 2.0 * 3.14159265358979 * i / Count;
    const Vec3 outward(std::cos(angle), std::sin(angle), 0.0);
    const Vec3 across =
      0.2 * (std::cos(0.5 * angle) * outward + std::sin(0.5 * angle) * Vec3::UnitZ());
    strip.addPoint(outward + across);
    strip.addPoint(outward - across);
  }
  for (Index i = 0; i < Count; ++i)
  {
    const bool isLast = i + 1 == Count;
    const Index a = 2 * i;
    const Index c = isLast ? 1 : a + 2;
    const Index d = isLast ? 0 : a + 3;
    strip.addFace({ a, c, a + 1 });
    strip.addFace({ a + 1, c, d });
  }
  EXPECT_FALSE(solidSheets(strip, everywhere, 0.02));
}
